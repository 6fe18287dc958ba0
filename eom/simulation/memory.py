"""Where the numbers of a run stand in the arrays that compiled loops work in.

Plain arrays and places in them, which compile fastest.
"""

X, NEW, ERROR, K0, K1, K2, K3, K4, K5, K6, SIZE, GROWING, DIRECTION, DRIFT, V0, V1, V2, V3, RIGHT = range(19)
VECTORS = 19
"""Rows of the vectors over the states: state, state and error after a step, rates of its stages, size that counts as
one and whether the own value adds to it, direction of the fastest root, df/dt, increments of implicit stages."""

STATES, LIMITS, INPUTS, OUTPUTS, U, PARAMETERS, SCRATCH, RESULTS = range(8)
"""Of the integers that say how many there are of each, and where they begin in the program's memory; results are
rates of the states, margins of the limits, outputs."""

TIME, STEP, ROOT, LOOKED, AGE, FACTORED, METHOD_NOW = range(7)
CLOCK = 7
"""Of the clock: instant [s], step that comes next [s], fastest root [1/s], when it was looked for [s], steps since the
Jacobian was made, step of its factors [s], adaptive method in use."""

METHOD, LARGEST, TOLERANCE = range(3)
"""Of the settings: method, fixed or largest step [s], error of a step over the size of the states."""
AUTOMATIC, RUNGE_KUTTA, DORMAND_PRINCE, ROSENBROCK = range(4)

REJECTED, SAMPLES, EVENTS = 4, 5, 6
COUNTS = 7
"""Of the counts: steps by each method, steps rejected, samples taken, events found."""

BEFORE, NOW, SHARE = range(3)
"""Rows of the margins: at the state, at the end of a step, share of the step at which each changes its sign."""

EVENT_TIME, EVENT_LIMIT, EVENT_REACHED, EVENT_STATE = range(4)
"""Columns of the events: instant [s], number of the limit, 1 if it was reached and 0 if left, state."""

DONE, TERMINAL, UNSTABLE, INACCURATE, COLLAPSED, DIVERGED, FULL = range(7)
"""How a run ends: at the instant asked for; at a limit that ends it; with a fixed step beyond stability; with one whose
error is too large; with a step too small to go on; with numbers that are none; without room for more events."""
