"""Appendices A, C, D and E of S. Zhu's thesis as printed, element by element, and what is wrong with them.

An element reads ``row,column: expression``; what is not listed is zero. Symbols are those of the parameter sets, with
``Y_b1`` for Y_beta1, ``Y_r1`` for Y_psidot1, ``Y_d4`` for Y_delta4, N alike. Whole matrices of the print are written as
lists of their elements.
"""

PRINTED = {
    "A.M": """
        1,1: -m2*(l_c1 + l_c21)
        1,2: -m2*l_c21
        1,3: (m1 + m2)*U
        2,1: I_zz1 + m2*l_c1*(l_c1 + l_c21)
        2,2: m2*l_c1*l_c21
        2,3: -m2*l_c1*U
        3,1: I_zz2 + m2*l_c21*(l_c1 + l_c21)
        3,2: I_zz2 + m2*l_c21**2
        3,3: -m2*l_c21*U
        4,4: 1
    """,
    "A.P": """
        1,1: ((l_c21 + b23 + l_c1)*C_r23 - C_f11*a11 + C_r12*b12)/U - (m1 + m2)*U
        1,2: (l_c21 + b23)*C_r23/U
        1,3: -(C_f11 + C_r12 + C_r23)
        1,4: C_r23
        2,1: m2*l_c1*U - ((l_c1 + b23 + l_c21)*C_r23*l_c1 + C_f11*a11**2 + C_r12*b12**2)/U
        2,2: -(l_c21 + b23)*C_r23*l_c1/U
        2,3: C_r12*b12 - C_f11*a11 + C_r23*l_c1
        2,4: -C_r23*l_c1
        3,1: m2*l_c21*U - (l_c21 + b23 + l_c1)*C_r23*(l_c21 + b23)/U
        3,2: -(l_c21 + b23)**2*C_r23/U
        3,3: (l_c21 + b23)*C_r23
        3,4: -(l_c21 + b23)*C_r23
        4,2: 1
    """,
    "A.H1": """
        1,1: C_f11
        2,1: C_f11*a11
    """,
    "A.H2": """
        1,1: C_r12
        2,1: -C_r12*b12
    """,
    "A.H3": """
        1,1: C_r23
        2,1: -C_r23*l_c1
        3,1: -C_r23*(l_c21 + b23)
    """,
    "A.M_nl": """
        1,4: 1
        2,1: -(l_c1 + l_c21)*m2
        2,2: -l_c21*m2
        2,3: (m1 + m2)*U
        3,1: I_zz1 + l_c1*(l_c1 + l_c21)*m2
        3,2: l_c1*l_c21*m2
        3,3: -l_c1*m2*U
        4,1: I_zz2 + l_c21*(l_c1 + l_c21)*m2
        4,2: I_zz2 + l_c21**2*m2
        4,3: -l_c21*m2*U
    """,
    "A.P_nl": """
        1,3: 1
        2,2: -(m1*U + m2*U)
        3,2: l_c1*m2*U
        4,2: l_c21*m2*U
    """,
    "A.H_nl": """
        1,1: a11
        1,2: -b12
        1,3: -l_c1
        2,3: -b23 - l_c21
        4,1: 1
        4,2: 1
        4,3: 1
    """,
    "C.M": """
        1,2: I_sxx1 - l_c1*m_s1*(h_s1 - h_r1)
        1,3: -l_c1*m1*U
        1,4: -I_zz1
        2,1: L_r1f + L_r1r
        2,2: I_sxx1 + m_s1*(h_s1 - h_r1)**2 - h_cr1*m_s1*(h_s1 - h_r1)
        2,3: m_s1*U*(h_s1 - h_r1) - h_cr1*m1*U
        2,4: -I_sxz1
        2,13: -L_r1f - L_r1r
        3,1: L_r1f + L_r1r
        3,3: -m_u1*U*(h_u1 - h_r1)
        3,4: I_u1xz
        3,13: -(L_r1f + L_r1r)
        4,2: m_s1*(h_s1 - h_r1)
        4,3: m1*U
        4,6: m_s2*(h_s2 - h_r2)
        4,7: m2*U
        4,10: m_s3*(h_s3 - h_r3)
        4,11: m3*U
        5,2: l_c21*m_s1*(h_s1 - h_r1)
        5,3: l_c21*m1*U
        5,6: -I_sxz2
        5,8: I_zz2
        5,10: -l_c22*m_s3*(h_s3 - h_r3)
        5,11: -l_c22*m3*U
        6,2: h_cr2*m_s1*(h_s1 - h_r1)
        6,3: h_cr2*m1*U
        6,5: L_r2
        6,6: I_xx2 + m_s2*(h_s2 - h_r2)**2
        6,7: m_s2*U*(h_s2 - h_r2)
        6,8: -I_sx2
        6,10: h_cr3*m_s3*(h_s3 - h_r3)
        6,11: h_cr3*m3*U
        6,15: -L_r2
        7,5: L_r2
        7,7: -m_u2*U*(h_u2 - h_r2)
        7,8: I_u2xz
        7,15: -L_r2
        7,16: -I_u2xx - m_u2*(h_u2 - h_r2)**2
        8,10: l_c3*m_s3*(h_s3 - h_r3) + I_xz3
        8,11: l_c3*m3*U
        8,12: -I_zz3
        9,9: L_r3
        9,10: I_xx3 + m_s3*(h_s3 - h_r3)**2 - h_cr3*m_s3*(h_s3 - h_r3)
        10,12: -I_u3xz
        10,17: L_r3
        10,18: I_u3xx + m_u3*(h_u3 - h_r3)**2
        11,2: h_cr1
        11,3: U
        11,4: -l_c1
        11,6: -h_cr2
        11,7: -U
        11,8: -l_c21
        12,6: h_cr2
        12,7: U
        12,8: -l_c22
        12,10: -h_cr3
        12,11: -U
        12,12: -l_c3
        13,1: 1
        14,5: 1
        15,9: 1
        16,13: 1
        17,15: 1
        18,17: 1
    """,
    "C.N": """
        1,3: N_b1 + l_c1*Y_b1
        1,4: N_r1 + l_c1*Y_r1 - l_c1*m1*U
        2,1: (K_r1f + K_r1r + K_12) - m_s1*g*(h_s1 - h_r1)
        2,3: h_cr1*Y_b1
        2,4: m_s1*U*(h_s1 - h_r1) + h_cr1*Y_r1 - h_cr1*m1*U
        2,5: -K_12
        2,13: -K_r1f - K_r1r
        3,1: K_r1f + K_r1r
        3,3: -h_r1*Y_b1
        3,4: -h_r1*Y_r1 - m_u1*U*(h_u1 - h_r1)
        3,13: m_u1*g*(h_u1 - h_r1) - K_r1f - K_r1r - K_t1f - K_t1r
        4,3: -Y_b1
        4,4: m1*U - Y_r1
        4,7: -Y_b2
        4,8: m2*U - Y_r2
        4,11: -Y_b3
        4,12: m3*U - Y_r3
        5,3: -l_c21*Y_b1
        5,4: l_c21*m1*U - l_c21*Y_r1
        5,7: -N_b2
        5,8: -N_r2
        5,11: l_c22*Y_b3
        5,12: l_c22*Y_r3 - l_c22*m3*U
        6,1: -K_12
        6,3: -h_cr2*Y_b1
        6,4: h_cr2*m1*U - h_cr2*Y_r1
        6,5: K_r2 + K_12 + K_23 - m_s2*g*(h_s2 - h_r2)
        6,8: m_s2*U*(h_s2 - h_r2)
        6,9: -K_23
        6,11: -h_cr3*Y_b3
        6,12: h_cr3*m3*U - h_cr3*Y_r3
        6,15: -K_r2
        7,5: K_r2
        7,7: -h_r2*Y_b2
        7,8: -m_u2*U*(h_u2 - h_r2) - h_r2*Y_r2
        7,15: m_u2*g*(h_u2 - h_r2) - (K_r2 + K_tr2)
        8,11: N_b3 - l_c3*Y_b3
        8,12: l_c3*m3*U + N_r3 - l_c3*Y_r3
        9,5: -K_23
        9,9: K_23 + K_r3 - m_s3*g*(h_s3 - h_r3)
        9,11: h_cr3*Y_b3
        9,12: m_s3*U*(h_s3 - h_r3) + h_cr3*Y_r3 - h_cr3*m3*U
        9,17: -K_r3
        10,9: -K_r3
        10,11: h_r3*Y_b3
        10,12: m_u3*U*(h_u3 - h_r3) + h_r3*Y_r3
        10,17: K_r3 + K_t3 - m_u3*g*(h_u3 - h_r3)
        11,4: U
        11,8: -U
        12,8: U
        12,12: -U
        13,2: -1
        14,6: -1
        15,10: -1
        16,14: -1
        17,16: -1
        18,18: -1
    """,
    "C.Q": """
        1,1: N_d1f + l_c1*Y_d1f
        2,1: h_cr1*Y_d1f
        3,1: -h_r1*Y_d1f
        4,1: -Y_d1f
        5,1: -l_c21*Y_d1f
        6,1: -h_cr2*Y_d1f
    """,
    "C.R": """
        2,1: -1
        2,2: -1
        3,1: -1
        3,2: -1
        6,3: -1
        7,3: 1
        9,4: -1
        10,4: 1
    """,
    "C.W": """
        5,1: -1
        8,2: 1
    """,
    "D.J": """
        1,1: l_c1*m1*U
        1,2: I_zz1
        2,1: m1*U
        2,3: m2*U
        2,5: m3*U
        3,1: l_c21*m1*U
        3,4: I_zz2
        3,5: -l_c22*m3*U
        4,5: -l_c3*m3*U
        4,6: I_zz3
        5,1: 1
        5,2: -l_c1/U
        5,3: -1
        5,4: -l_c21/U
        6,3: 1
        6,4: -l_c22/U
        6,5: -1
        6,6: -l_c3/U
    """,
    "D.K": """
        1,1: -(N_b1 + l_c1*Y_b1)
        1,2: -(N_r1 - l_c1*m1*U + l_c1*Y_r1)
        2,1: -Y_b1
        2,2: m1*U - Y_r1
        2,3: -Y_b2
        2,4: m2*U - Y_r2
        2,5: -Y_b3
        2,6: m3*U - Y_r3
        3,1: -l_c21*Y_b1
        3,2: l_c21*m1*U - l_c21*Y_r1
        3,3: -N_b2
        3,4: -N_r2
        3,5: l_c22*Y_b3
        3,6: l_c22*Y_r3 - l_c22*m3*U
        4,5: l_c3*Y_b3 - N_b3
        4,6: l_c3*Y_r3 - l_c3*m3*U - N_r3
        5,2: 1
        5,4: -1
        6,4: 1
        6,6: -1
    """,
    "D.L": """
        1,1: -(N_d11 + l_c1*Y_d11)
        2,1: -Y_d11
        3,1: -l_c21*Y_d11
    """,
    "D.T": """
        2,1: -Y_d4
        2,2: -Y_d5
        2,3: -Y_d6
        2,4: -Y_d7
        2,5: -Y_d8
        2,6: -Y_d9
        3,1: -N_d4
        3,2: -N_d5
        3,3: -N_d6
        3,4: l_c22*Y_d7
        3,5: l_c22*Y_d8
        3,6: l_c22*Y_d9
        4,4: l_c3*Y_d7 - N_d7
        4,5: l_c3*Y_d8 - N_d8
        4,6: l_c3*Y_d9 - N_d9
    """,
    "D.V": """
        3,1: -1
        4,2: 1
    """,
    "E.K_n": """
        1,2: -l_c1*m1*U
        2,2: -m1*U
        2,4: -m2*U
        2,6: -m3*U
        3,2: -l_c21*m1*U
        3,6: l_c22*m3*U
        4,6: l_c3*m3*U
        5,2: -1
        5,4: 1
        6,4: -1
        6,6: 1
    """,
    "E.L_n": """
        1,1: a11 + l_c1
        1,2: l_c1 - b12
        1,3: l_c1 - b13
        2,1: 1
        2,2: 1
        2,3: 1
        2,4: 1
        2,5: 1
        2,6: 1
        2,7: 1
        3,1: l_c21
        3,2: l_c21
        3,3: l_c21
        3,4: -b24
        3,5: -b25
        3,6: -b26
        3,7: -l_c22
        3,8: -l_c22
        4,8: -(b37 + l_c3)
        4,9: -(b38 + l_c3)
        4,10: -(b39 + l_c3)
    """,
    "E.R_n": """
        3,1: 1
    """,
}
"""By appendix and matrix."""

CORRECTED = {
    # The states are psi_dot_1, Delta_psi_dot, beta_1, Delta_psi and the rows articulation, side, yaw 1, yaw 2, as in
    # M_nl: P_nl is printed for the states in the order Delta_psi, psi_dot_1, .., H_nl for the rows yaw 1, yaw 2, ..
    "A.P_nl": """
        1,2: 1
        1,3: 0
        2,1: -(m1 + m2)*U
        2,2: 0
        3,1: l_c1*m2*U
        3,2: 0
        4,1: l_c21*m2*U
        4,2: 0
    """,
    "A.H_nl": """
        1,1: 0
        1,2: 0
        1,3: 0
        2,1: 1
        2,2: 1
        2,3: 1
        3,1: a11
        3,2: -b12
        3,3: -l_c1
        4,1: 0
        4,2: 0
        4,3: -(b23 + l_c21)
    """,
    # (1,2): row 1 is -(3.21b) - l_c1 (3.21a), with the product of inertia. (3,14), (9,11) .. (10,11): lost lines.
    # (6,10), (6,11): F_cy2 acts on the first semitrailer, at h_cr2. The rest: indices.
    "C.M": """
        1,2: I_sxz1 - l_c1*m_s1*(h_s1 - h_r1)
        3,14: -(I_u1xx + m_u1*(h_u1 - h_r1)**2)
        6,6: I_sxx2 + m_s2*(h_s2 - h_r2)**2
        6,8: -I_sxz2
        6,10: h_cr2*m_s3*(h_s3 - h_r3)
        6,11: h_cr2*m3*U
        8,10: l_c3*m_s3*(h_s3 - h_r3) + I_sxz3
        9,10: I_sxx3 + m_s3*(h_s3 - h_r3)**2 - h_cr3*m_s3*(h_s3 - h_r3)
        9,11: m_s3*U*(h_s3 - h_r3) - h_cr3*m3*U
        9,12: -I_sxz3
        9,17: -L_r3
        10,9: -L_r3
        10,11: m_u3*U*(h_u3 - h_r3)
    """,
    "C.N": """
        6,11: -h_cr2*Y_b3
        6,12: h_cr2*m3*U - h_cr2*Y_r3
        7,15: m_u2*g*(h_u2 - h_r2) - (K_r2 + K_t2)
    """,
    # delta_1f is the tractor semitrailer's name
    "C.Q": """
        1,1: N_d11 + l_c1*Y_d11
        2,1: h_cr1*Y_d11
        3,1: -h_r1*Y_d11
        4,1: -Y_d11
        5,1: -l_c21*Y_d11
        6,1: -h_cr2*Y_d11
    """,
    # action and reaction: row 7 is -(3.22d)
    "C.R": """
        7,3: -1
    """,
    # row 4 is +yaw 3, unlike row 8 of Appendix C
    "D.V": """
        4,2: -1
    """,
    # the print has lost columns
    "E.L_n": """
        2,8: 1
        2,9: 1
        3,9: -l_c22
        4,7: -(b37 + l_c3)
        4,8: -(b38 + l_c3)
        4,9: -(b39 + l_c3)
        4,10: 0
    """,
    "E.R_n": """
        4,2: 1
    """,
}
"""The elements that are wrong or lost in print, as they must be."""

# Appendix B, at U = 10 m/s; N and Y by unit, those of delta by axle
DERIVATIVES = {
    "N_b1": 2208200.0,
    "N_b2": 7902300.0,
    "N_b3": 4705500.0,
    "N_d11": 847530.0,
    "N_d4": -1895100.0,
    "N_d5": -2634100.0,
    "N_d6": -3373100.0,
    "N_d7": -1128400.0,
    "N_d8": -1568500.0,
    "N_d9": -2008600.0,
    "N_r1": -1314400.0,
    "N_r2": -3764800.0,
    "N_r3": -2241800.0,
    "Y_b1": -1264400.0,
    "Y_b2": -1745700.0,
    "Y_b3": -1039500.0,
    "Y_d11": 424000.0,
    "Y_d4": 581900.0,
    "Y_d5": 581900.0,
    "Y_d6": 581900.0,
    "Y_d7": 346500.0,
    "Y_d8": 346500.0,
    "Y_d9": 346500.0,
    "Y_r1": 220820.0,
    "Y_r2": 790230.0,
    "Y_r3": 470550.0,
}
