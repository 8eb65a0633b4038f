"""The pages of the reference, in the order of a textbook, and the headers whose names they list."""

import fnmatch
import sys

# file, title, description, headers in the order in which their names appear
PAGES = [
    ("symbols", "Symbols", "The symbols of a model: coordinates, speeds, parameters, inputs and time.",
     "describe/symbol.hpp describe/symbol_name.hpp"),
    ("functions", "Functions", "Functions of scalar expressions. All arguments and results are scalars; angles are in rad.",
     "describe/functions.hpp describe/composed.hpp describe/external.hpp"),
    ("vectors", "Vectors", "Vectors, dyadics, their products, and derivatives in a frame.",
     "describe/expression.hpp describe/operators.hpp describe/motion.hpp"),
    ("frames", "Frames", "Reference frames, their orientations and angular velocities.", "describe/frame.hpp"),
    ("points", "Points", "Points, their positions and velocities.", "describe/point.hpp"),
    ("bodies", "Masses and inertia", "Particles, rigid bodies and inertia dyadics.", "describe/body.hpp"),
    ("joints", "Joints", "Mechanisms described by their joints, and constraints that couple joints.",
     "describe/joints/joints.hpp describe/joints/lower_pairs.hpp describe/joints/*.hpp compiled/reactions.hpp"),
    ("beams", "Beams", "Bodies that bend, twist and stretch, and places on them.",
     "describe/beams/beam.hpp describe/beams/section.hpp describe/beams/deformations.hpp describe/beams/shapes.hpp"),
    ("blocks", "Blocks", "Filters, delays and controllers with state variables of their own, DC motors and muscles.",
     "describe/blocks/lag.hpp describe/blocks/delay.hpp describe/blocks/pid.hpp describe/blocks/dc_motor.hpp describe/blocks/*.hpp mechanics/loads/muscle_parameters.hpp "
     "mechanics/loads/muscle_equilibrium.hpp"),
    ("loads", "Forces and torques", "Forces, torques, springs, dampers and gravity; loads along pathways.",
     "describe/load.hpp describe/pathway.hpp describe/path_load.hpp"),
    ("contact", "Contact and friction", "Contacts between bodies, and laws of friction.",
     "describe/contact.hpp describe/friction.hpp describe/bristle.hpp describe/joints/friction_load.hpp"),
    ("wheels", "Wheels and tyres", "Wheels, the ground on which they roll, and tyres.",
     "describe/wheel.hpp describe/surface.hpp describe/tyre_words.hpp describe/tyre_record.hpp"),
    ("systems", "Systems", "Systems for Kane's method and for Lagrange's.", "describe/system.hpp describe/extended.hpp describe/formulation.hpp"),
    ("constraints", "Constraints", "Configuration and velocity constraints, and auxiliary speeds.", "describe/constraint.hpp"),
    ("results", "Results", "The equations of motion as compiled functions, their arguments and their status.",
     "compiled/equations_of_motion.hpp compiled/function.hpp compiled/state.hpp compiled/named_values.hpp compiled/status.hpp "
     "base/status.hpp base/outcome.hpp derivation/model_error.hpp mechanics/quantity.hpp compiled/*.hpp numeric/fixed_matrix.hpp "
     "numeric/as_eigen.hpp base/text.hpp base/file_path.hpp quantities/*.hpp"),
    ("linearization", "Linearization", "Linearized equations, second derivatives, the regressor and base parameters.",
     "compiled/linearization.hpp compiled/second_order.hpp compiled/regressor.hpp runtime/base_parameters.hpp "
     "runtime/linearization_point.hpp"),
    ("consistency", "Consistent states", "States that satisfy the constraints.",
     "steps/assemble.hpp runtime/assemble.hpp steps/check_independence.hpp steps/least_multipliers.hpp numeric/*.hpp"),
    ("control", "Control", "Discretization, linear-quadratic regulators, gain schedules and Kalman filters.", "control/*.hpp"),
    ("steps", "Steps of fixed length", "Integration in real time, and the derivatives of a step.", "steps/*.hpp"),
    ("simulation", "Simulation", "Adaptive integration by SUNDIALS, events, trajectories and operating points.",
     "simulations/simulate.hpp simulations/simulation.hpp simulations/settings.hpp simulations/model.hpp simulations/trajectory/*.hpp "
     "simulations/events/*.hpp base/crossing.hpp simulations/*.hpp simulations/*/*.hpp base/statistics.hpp"),
    ("ensembles", "Ensembles", "Many simulations of one system, on threads and machines.",
     "ensembles/ensemble.hpp ensembles/study.hpp ensembles/runs.hpp ensembles/distribution.hpp ensembles/run_output.hpp "
     "ensembles/reduction.hpp ensembles/*.hpp ensembles/hdf5/*.hpp mpi/*.hpp"),
    ("batches", "Batches", "Many systems side by side, in SIMD vectors and on several threads.", "batches/*.hpp"),
    ("figures", "Figures", "Textbook figures drawn from the model.", "figures/*.hpp"),
    ("animation", "Animation", "Animated pictures on a page that a browser can open.",
     "animate/write_page.hpp animate/animated.hpp animate/*.hpp"),
    ("robots", "Robots", "Robots from URDF and SDF files.", "robots/*.hpp robots/*/*.hpp"),
    ("flexible-bodies", "Flexible bodies", "Flexible bodies given by numbers, from files.",
     "describe/flexible/*.hpp flexible/*.hpp flexible/*/*.hpp"),
    ("run-time", "At run time", "Models derived at run time, which can be printed and evaluated, and models without types.",
     "runtime/model.hpp runtime/builder.hpp runtime/*.hpp runtime/building/*.hpp symbolic/printing/*.hpp symbolic/*.hpp symbolic/*/*.hpp mechanics/*/*.hpp"),
    ("export", "Export", "Models as C, CasADi functions and FMUs.", "exporting/*.hpp exporting/*/*.hpp"),
]


def matches(path, pattern):
    """Whether a path matches a pattern; * stands for a name, not for folders."""
    return fnmatch.fnmatch(path, pattern) and path.count("/") == pattern.count("/")


def place_of(header):
    """The page of a header and its rank on the page, by the first matching pattern without a star, or else the first with one."""
    for exactly in (True, False):
        for page, *_, patterns in PAGES:
            for rank, pattern in enumerate(patterns.split()):
                if ("*" not in pattern) == exactly and matches(header.removeprefix("kanexpr/"), pattern):
                    return page, rank
    sys.exit(f"docs/site/reference_pages.py: PAGES has no page for {header}")
