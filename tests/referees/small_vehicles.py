"""Small vehicle files for comparison with referees: each shows one thing that linear generators get wrong."""

CAR = """
name: Bounce and pitch of a car body
gravity: 9.81
trim: {speed: U}
parameters: {U: 10 m/s}
bodies:
  body: {mass: 1200, at: [0, 0, 0.6], inertia: {xx: 500, yy: 1900, zz: 2100, xz: 40}}
connectors:
  plane: {type: rigid_point, between: [body, ground], at: [0, 0, 0.6], forces: 1, moments: 2, axis: [0, 1, 0]}
  front: {type: flex_point, between: [body, ground], at: [1.2, 0, 0.3], forces: 1, axis: [0, 0, 1],
    stiffness: 36e3, damping: 3e3}
  rear: {type: flex_point, between: [body, ground], at: [-1.5, 0, 0.3], forces: 1, axis: [0, 0, 1],
    stiffness: 42e3, damping: 4e3}
actuators:
  front_road: {body: body, at: [1.2, 0, 0.3], along: [0, 0, 1], gain: 36e3, rate_gain: 3e3, unit: m}
  heave: {body: body, along: [0, 0, 1]}
sensors:
  pitch: {body: body, about: [0, 1, 0], measure: position}
  height: {body: body, at: [0.5, 0, 0.7], along: [0, 0, 1], measure: position}
  v_z: {body: body, along: [0, 0, 1], measure: velocity, frame: body}
"""

HALF_CAR = """
name: Half car with unsprung masses that pitch with the body
gravity: 9.81
trim: {speed: U}
parameters: {U: 10 m/s}
bodies:
  body: {mass: 600, at: [0, 0, 0.6], inertia: {xx: 300, yy: 950, zz: 1000}}
  front: {mass: 40, at: [1.2, 0, 0.3], inertia: {xx: 1, yy: 1.5, zz: 1}}
  rear: {mass: 50, at: [-1.5, 0, 0.3], inertia: {xx: 1, yy: 1.5, zz: 1}}
connectors:
  plane: {type: rigid_point, between: [body, ground], at: [0, 0, 0.6], forces: 1, moments: 2, axis: [0, 1, 0]}
  front_guide: {type: rigid_point, between: [front, body], at: [1.2, 0, 0.3], forces: 2, moments: 3, axis: [0.1, 0, 1]}
  rear_guide: {type: rigid_point, between: [rear, body], at: [-1.5, 0, 0.3], forces: 2, moments: 3, axis: [0, 0, 1]}
  front_spring: {type: spring, between: [front, body], ends: [[1.2, 0, 0.3], [1.25, 0, 0.8]],
    stiffness: 18e3, damping: 1500}
  rear_spring: {type: spring, between: [rear, body], ends: [[-1.5, 0, 0.3], [-1.5, 0, 0.7]],
    stiffness: 21e3, damping: 2e3}
  front_tyre: {type: flex_point, between: [front, ground], at: [1.2, 0, 0], forces: 1, axis: [0, 0, 1],
    stiffness: 2e5, damping: 300}
  rear_tyre: {type: flex_point, between: [rear, ground], at: [-1.5, 0, 0], forces: 1, axis: [0, 0, 1],
    stiffness: 2e5, damping: 300}
actuators:
  heave: {body: body, along: [0, 0, 1]}
  front_active: {body: body, reaction_on: front, at: [1.2, 0, 0.3], along: [0, 0, 1]}
sensors:
  body_acceleration: {body: body, at: [0.3, 0, 0.6], along: [0, 0, 1], measure: acceleration}
  front_acceleration: {body: front, along: [0, 0, 1], measure: acceleration}
  rear_acceleration: {body: rear, along: [0, 0, 1], measure: acceleration, frame: body}
  travel: {body: body, relative_to: rear, at: [-1.5, 0, 0.3], along: [0, 0, 1], measure: position}
"""

TRUCK_TRAILER = """
name: Truck and trailer with a compliant hitch
gravity: 9.81
trim: {speed: U, hold: true}
parameters: {U: 20 m/s}
tyres:
  steer: {per: axle, cornering: 2e5}
  drive: {per: axle, cornering: 4e5}
  tow: {per: axle, cornering: 3e5, trail: 0.05}
bodies:
  truck: {mass: 8000, at: [0, 0, 1], inertia: {xx: 1e4, yy: 3e4, zz: 4e4}}
  trailer: {mass: 9000, at: [-7.6, 0, 1.2], inertia: {xx: 1e4, yy: 4e4, zz: 5e4}}
connectors:
  road: {type: support, body: truck, at: [0, 0, 0], carries: [z, roll, pitch]}
  trailer_road: {type: support, body: trailer, at: [-7.6, 0, 0], carries: [z, roll, pitch]}
  drawbar: {type: rigid_point, between: [trailer, truck], at: [-2.9, 0, 0.5], forces: 1, axis: [1, 0, 0]}
  hitch: {type: flex_point, between: [trailer, truck], at: [-2.9, 0, 0.5], forces: 1, axis: [0, 1, 0],
    stiffness: 1e5, damping: 2e4}
  front: {type: tyre, body: truck, at: [2.0, 0, 0], tyre: steer, steered: true}
  rear: {type: tyre, body: truck, at: [-1.8, 0, 0], tyre: drive}
  axle: {type: tyre, body: trailer, at: [-8.2, 0, 0], tyre: tow}
sensors:
  truck_ay: {body: truck, along: [0, 1, 0], measure: acceleration}
  trailer_ay: {body: trailer, along: [0, 1, 0], measure: acceleration}
  stretch: {body: trailer, relative_to: truck, at: [-2.9, 0, 0.5], along: [0, 1, 0], measure: position}
  slip: {body: truck, at: [-1.8, 0, 0], along: [0, 1, 0], measure: velocity, frame: body, gain: 1/U}
"""

CRANE = """
name: Trolley with a hanging uniform bar
gravity: 9.81
bodies:
  trolley: {mass: 3, at: [0, 0, 0], inertia: {xx: 1, yy: 1, zz: 1}}
  bar: {mass: 4, at: [0, 0, -0.6], inertia: {xx: 0.48, yy: 0.48, zz: 0}}
connectors:
  rail: {type: rigid_point, between: [trolley, ground], at: [0, 0, 0], forces: 2, moments: 3, axis: [1, 0, 0]}
  hinge: {type: rigid_point, between: [bar, trolley], at: [0, 0, 0], forces: 3, moments: 2, axis: [0, 1, 0]}
actuators:
  push: {body: trolley, along: [1, 0, 0]}
sensors:
  trolley_acceleration: {body: trolley, along: [1, 0, 0], measure: acceleration}
  tip_acceleration: {body: bar, at: [0, 0, -1.2], along: [1, 0, 0], measure: acceleration}
"""

TRIANGLE = """
name: Two rods spread by their weight, held together by a spring
gravity: 9.81
parameters: {h: 0.8}
bodies:
  left: {mass: 2, at: [-0.3, 0, h/2], inertia: {xx: 0.11, yy: 0.17, zz: 0.06}}
  right: {mass: 3, at: [0.25, 0, h/2], inertia: {xx: 0.16, yy: 0.22, zz: 0.06}}
connectors:
  foot: {type: rigid_point, between: [left, ground], at: [-0.6, 0, 0], forces: 3}
  apex: {type: rigid_point, between: [right, left], at: [0, 0, h], forces: 3, moments: 2, axis: [0, 1, 0]}
  floor: {type: rigid_point, between: [right, ground], at: [0.5, 0, 0], forces: 1, axis: [0, 0, 1]}
  strut: {type: spring, between: [left, right], ends: [[-0.5, 0, h/6], [0.4, 0, h/5]], stiffness: 900, damping: 7}
loads:
  burden: {body: right, at: [0, 0, h], force: [0, 0, -150]}
actuators:
  pull: {body: right, at: [0.5, 0, 0], along: [1, 1, 0]}
sensors:
  foot_acceleration: {body: right, at: [0.5, 0, 0], along: [1, 0, 0], measure: acceleration}
  tip: {body: left, about: [1, 0, 0], measure: position}
"""

RELAXATION = """
name: Car on tyres whose contact patches have no mass and lag behind
gravity: 9.81
trim: {speed: U, hold: true}
parameters: {U: 15 m/s}
bodies:
  car: {mass: 1300, at: [-1.2, 0, 0.5], inertia: {xx: 400, yy: 1900, zz: 2100}}
  front_patch: {mass: 0, at: [0, 0, 0]}
  rear_patch: {mass: 0, at: [-2.6, 0, 0]}
connectors:
  road: {type: support, body: car, at: [-1.2, 0, 0], carries: [z, roll, pitch]}
  front_guide: {type: rigid_point, between: [front_patch, car], at: [0, 0, 0], forces: 2, moments: 3, axis: [0, 1, 0]}
  rear_guide: {type: rigid_point, between: [rear_patch, car], at: [-2.6, 0, 0], forces: 2, moments: 3, axis: [0, 1, 0]}
  front_wall:
    {type: flex_point, between: [front_patch, car], at: [0, 0, 0], forces: 1, axis: [0, 1, 0], stiffness: 15e4}
  rear_wall:
    {type: flex_point, between: [rear_patch, car], at: [-2.6, 0, 0], forces: 1, axis: [0, 1, 0], stiffness: 16e4}
  front_slip: {type: slip_damper, body: front_patch, at: [0, 0, 0], axis: [0, 1, 0], damping: 9e4/U}
  rear_slip: {type: slip_damper, body: rear_patch, at: [-2.6, 0, 0], axis: [0, 1, 0], damping: 11e4/U}
actuators:
  yaw_moment: {body: car, about: [0, 0, 1]}
  side_wind: {body: car, at: [-1, 0, 0.5], along: [0, 1, 0]}
sensors:
  ay: {body: car, along: [0, 1, 0], measure: acceleration}
  yaw_rate: {body: car, about: [0, 0, 1], measure: velocity, frame: body}
  lag: {body: front_patch, relative_to: car, along: [0, 1, 0], measure: position}
"""
