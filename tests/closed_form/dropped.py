"""What the thesis drops from the yaw-roll matrices: full less thesis, element by element, by the kind of the term.

The notation is that of `printed`. Rows are combinations of balances: 1 is -(yaw 1 + l_c1 side 1), 2 is roll 1 - h_cr1
side 1, 3 is -tyre roll 1, 4 is the sum of the sides, 5 is yaw 2 + l_c21 side 1 - l_c22 side 3, 6 is roll 2 + h_cr2
(side 1 + side 3), 7 is -tyre roll 2, 8 is -(yaw 3 - l_c3 side 3), 9 is roll 3 - h_cr3 side 3, 10 is tyre roll 3.
"""

UNSPRUNG_ROLL_IN_THE_SIDE_BALANCE = """
    1,14: -l_c1*m_u1*(h_u1 - h_r1)
    2,14: -h_cr1*m_u1*(h_u1 - h_r1)
    4,14: m_u1*(h_u1 - h_r1)
    4,16: m_u2*(h_u2 - h_r2)
    4,18: m_u3*(h_u3 - h_r3)
    5,14: l_c21*m_u1*(h_u1 - h_r1)
    5,18: -l_c22*m_u3*(h_u3 - h_r3)
    6,14: h_cr2*m_u1*(h_u1 - h_r1)
    6,18: h_cr2*m_u3*(h_u3 - h_r3)
    8,18: l_c3*m_u3*(h_u3 - h_r3)
    9,18: -h_cr3*m_u3*(h_u3 - h_r3)
"""
"""m_u (h_u - h_r) phi_t_ddot."""

ROLL_YAW_PRODUCTS = """
    1,2: -m_s1*(a11 - a11s)*(h_s1 - h_r1)
    2,4: m_s1*(a11 - a11s)*(h_s1 - h_r1)
    5,6: m_s2*(l_c21 - a2s)*(h_s2 - h_r2)
    6,8: m_s2*(l_c21 - a2s)*(h_s2 - h_r2)
    8,10: -m_s3*(l_c3 - a3s)*(h_s3 - h_r3)
    9,12: m_s3*(l_c3 - a3s)*(h_s3 - h_r3)
    3,4: m_s1*(a11 - a11s)*(h_u1 - h_r1)
    7,8: m_s2*(l_c21 - a2s)*(h_u2 - h_r2)
    10,12: -m_s3*(l_c3 - a3s)*(h_u3 - h_r3)
    1,14: I_u1xz + m_s1*(a11 - a11s)*(h_u1 - h_r1)
    5,16: -I_u2xz - m_s2*(l_c21 - a2s)*(h_u2 - h_r2)
    8,18: I_u3xz + m_s3*(l_c3 - a3s)*(h_u3 - h_r3)
"""
"""m_s x_s (h_s - h_r) and m_u x_u (h_u - h_r) with m_u x_u = -m_s x_s, and I_uxz in the yaw balance."""

TYRES_SWING_ABOUT_THE_ROLL_AXIS = """
    1,13: -h_r1/U*(N_b1 + l_c1*Y_b1)
    2,13: -h_cr1*h_r1/U*Y_b1
    3,13: h_r1*h_r1/U*Y_b1
    4,13: h_r1/U*Y_b1
    4,15: h_r2/U*Y_b2
    4,17: h_r3/U*Y_b3
    5,13: l_c21*h_r1/U*Y_b1
    5,15: h_r2/U*N_b2
    5,17: -l_c22*h_r3/U*Y_b3
    6,13: h_cr2*h_r1/U*Y_b1
    6,17: h_cr2*h_r3/U*Y_b3
    7,15: h_r2*h_r2/U*Y_b2
    8,17: -h_r3/U*(N_b3 - l_c3*Y_b3)
    9,17: -h_cr3*h_r3/U*Y_b3
    10,17: -h_r3*h_r3/U*Y_b3
"""
"""-h_r phi_t_dot / U, in the slip of every tyre of the unit."""
