"""Impact of a rigid body on a foam pad: force, deceleration, penetration and rebound over time, and what they mean.

>>> import dashpad
>>> drop = dashpad.Case(
...     impactor={"mass": "5 kg", "radius": "80 mm", "speed": "4 m/s"},
...     pad={"thickness": "40 mm", "material": "vn600"},
...     support={"type": "rigid"},
... )
>>> result = dashpad.solve(drop)
>>> print(f"{result.peak_acceleration / 9.80665:.1f} g, {result.status}")
67.0 g, released
>>> thicker = drop | {"pad.thickness": "50 mm"}
>>> print(dashpad.assess(thicker, "en-1078", keep_speed=True).title)
Passes: peak acceleration has 182 g to spare

Numbers are in SI; texts may have any unit that case files know. Input that cannot be computed raises
:class:`DashpadFaults`, a ValueError with all faults as data.
"""

from ._answer import Answer
from ._case import Case
from ._command import Store, compare, fall_height, fit, material_test, pulse, sensitivity, study
from ._native import DashpadFaults, Fault, library
from ._solve import Result, assess, batch, figures, solve, solve_for, standards

__version__ = library.dashpad_version().decode()
__all__ = [
    "Answer", "Case", "DashpadFaults", "Fault", "Result", "Store",
    "assess", "batch", "compare", "fall_height", "figures", "fit", "material_test", "pulse", "sensitivity", "solve",
    "solve_for", "standards", "study",
]
