"""The scenes by Drake (pip install drake): a discrete plant, with one point at each contact, or with compliant surfaces (hydroelastic),
which its manual advises for boxes (other bodies keep points). Of surfaces no impulses at points are told, and no residual is computed."""

import time
from dataclasses import dataclass, replace

import states
from states import Contact, Recorded, Refused


@dataclass
class Setting:
    """A setting: its step (s), and the approximation of contact."""

    name: str
    step: float
    approximation: str
    # Modulus of compliant surfaces, Pa; none: points.
    modulus: float | None = None

    def with_step(self, step):
        return replace(self, step=step)


SETTINGS = [
    Setting("defaults", 0.001, "lagged"),
    Setting("as advised", 0.001, "similar", 1e7),
    Setting("best found", 0.0002, "similar", 1e8),
]
# Of Hunt and Crossley, for compliant surfaces, s/m.
DISSIPATION = 20.0
CONVEX = Setting("SAP", 0.001, "sap")


def shape_of(geometry, body):
    if body.shape == "sphere":
        return geometry.Sphere(body.size[0])
    if body.shape == "box":
        return geometry.Box(*body.size)
    return {"capsule": geometry.Capsule, "cylinder": geometry.Cylinder}[body.shape](*body.size)


def material(geometry, plants, scene, setting, body):
    """Friction, and compliance where the setting has it; of a plane without a body."""
    properties = geometry.ProximityProperties()
    friction = plants.CoulombFriction(scene.friction, scene.friction)
    if not setting.modulus:
        geometry.AddContactMaterial(friction=friction, properties=properties)
        return properties
    geometry.AddContactMaterial(dissipation=DISSIPATION, friction=friction, properties=properties)
    if body is None:
        geometry.AddRigidHydroelasticProperties(properties)
    elif body.shape == "box":
        hint = 0.2 * min(body.size)
        geometry.AddCompliantHydroelasticProperties(hint, setting.modulus, properties)
    return properties


def is_continuous(scene, setting):
    """Where nothing touches the best found is an integrator with control of its error."""
    return scene.smooth and setting.name == "best found"


def build(scene, setting):
    from pydrake import geometry, math as drake_math
    from pydrake.multibody import plant as plants, tree
    from pydrake.systems.framework import DiagramBuilder

    builder = DiagramBuilder()
    config = plants.MultibodyPlantConfig(
        time_step=0.0 if is_continuous(scene, setting) else setting.step,
        discrete_contact_approximation=setting.approximation,
        contact_model="hydroelastic_with_fallback",
    )
    plant, graph = plants.AddMultibodyPlant(config, builder)
    plant.mutable_gravity_field().set_gravity_vector(list(scene.gravity))
    for normal, is_there in (([0, 0, 1.0], scene.floor), ([1.0, 0, 0], scene.wall)):
        if is_there:
            pose = geometry.HalfSpace.MakePose(normal, [0, 0, 0])
            properties = material(geometry, plants, scene, setting, None)
            plant.RegisterCollisionGeometry(plant.world_body(), pose, geometry.HalfSpace(), f"plane {normal}", properties)
    links, poses = {}, {}
    for body in scene.bodies:
        moments = [x / body.mass for x in body.moments()]
        inertia = tree.SpatialInertia(body.mass, [0, 0, 0], tree.UnitInertia(*moments))
        links[body.name] = plant.AddRigidBody(body.name, inertia)
        poses[body.name] = drake_math.RigidTransform(drake_math.RotationMatrix.MakeYRotation(body.about_y), body.position)
        if body.fixed:
            plant.WeldFrames(plant.world_frame(), links[body.name].body_frame(), poses[body.name])
        elif body.along_x:
            place = plant.AddFrame(tree.FixedOffsetFrame(f"guide of {body.name}", plant.world_frame(), poses[body.name]))
            plant.AddJoint(tree.PrismaticJoint(f"guide {body.name}", place, links[body.name].body_frame(), [1, 0, 0]))
        if not scene.hinges:
            there = drake_math.RigidTransform()
            properties = material(geometry, plants, scene, setting, body)
            plant.RegisterCollisionGeometry(links[body.name], there, shape_of(geometry, body), body.name, properties)
    for k, hinge in enumerate(scene.hinges):
        on = links[hinge.on] if hinge.on else plant.world_body()
        base = poses[hinge.on] if hinge.on else drake_math.RigidTransform()
        at = drake_math.RigidTransform(hinge.anchor)
        ends = [base.inverse().multiply(at), poses[hinge.body].inverse().multiply(at)]
        if k and k + 1 == len(scene.hinges):
            if not hinge.on:
                # A constraint to the world itself ends in a segmentation fault of 1.51.1: a body that is welded there stands for it.
                on = plant.AddRigidBody("end of the loop", tree.SpatialInertia(1.0, [0, 0, 0], tree.UnitInertia(1.0, 1.0, 1.0)))
                plant.WeldFrames(plant.world_frame(), on.body_frame(), at)
                ends[0] = drake_math.RigidTransform()
            plant.AddBallConstraint(on, ends[0].translation(), links[hinge.body], ends[1].translation())
        else:
            plant.AddJoint(tree.RevoluteJoint(
                f"hinge {k}",
                plant.AddFrame(tree.FixedOffsetFrame(f"on {k}", on.body_frame(), ends[0])),
                plant.AddFrame(tree.FixedOffsetFrame(f"of {k}", links[hinge.body].body_frame(), ends[1])),
                [0, 1, 0],
            ))
    plant.Finalize()
    return builder.Build(), plant, links, poses


def contacts(plant, context, numbers, h):
    found = []
    results = plant.get_contact_results_output_port().Eval(context)
    for k in range(results.num_point_pair_contacts()):
        info = results.point_pair_contact_info(k)
        pair = info.point_pair()
        # The force is that on B, the normal points from B to A.
        a, b = (numbers.get(int(index)) for index in (info.bodyA_index(), info.bodyB_index()))
        impulse = [-h * float(x) for x in info.contact_force()]
        found.append(Contact(a, b, list(info.contact_point()), list(pair.nhat_BA_W), impulse, -float(pair.depth), h, h))
    return found


def push(scene, plant, context, links):
    """Constant forces at centres of mass."""
    from pydrake.multibody.math import SpatialForce
    from pydrake.multibody.plant import ExternallyAppliedSpatialForce

    forces = []
    for body in scene.bodies:
        if body.force != (0.0, 0.0, 0.0):
            force = ExternallyAppliedSpatialForce()
            force.body_index, force.p_BoBq_B = links[body.name].index(), [0, 0, 0]
            force.F_Bq_W = SpatialForce([0, 0, 0], body.force)
            forces.append(force)
    if forces:
        plant.get_applied_spatial_force_input_port().FixValue(context, forces)


def run(scene, setting, samples):
    from pydrake.multibody.math import SpatialVelocity
    from pydrake.systems.analysis import ResetIntegratorFromFlags, Simulator

    if scene.restitution > 0:
        raise Refused("Drake has no restitution")
    diagram, plant, links, poses = build(scene, setting)
    simulator = Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    if not scene.hinges:
        for body in scene.bodies:
            if body.fixed or body.along_x:
                continue
            plant.SetFreeBodyPose(context, links[body.name], poses[body.name])
            plant.SetFreeBodySpatialVelocity(context, links[body.name], SpatialVelocity(body.angular, body.velocity))
    if is_continuous(scene, setting):
        ResetIntegratorFromFlags(simulator, "runge_kutta5", 0.01)
        simulator.get_mutable_integrator().set_target_accuracy(1e-12)
    push(scene, plant, context, links)
    simulator.Initialize()
    numbers = {int(links[body.name].index()): k for k, body in enumerate(scene.bodies)}
    recorded = Recorded(tracks={body.name: [] for body in scene.bodies}, wall=0.0)
    for sample in range(samples + 1):
        end = sample * scene.duration / samples
        if not is_continuous(scene, setting):
            end = round(end / setting.step) * setting.step
        begin = time.perf_counter()
        if end > 0:
            simulator.AdvanceTo(end + (0.0 if is_continuous(scene, setting) else 0.25 * setting.step))
        recorded.wall += time.perf_counter() - begin
        if recorded.wall > states.LONGEST:
            raise Refused(f"over {states.LONGEST} s")
        recorded.times.append(end)
        recorded.contacts.append(contacts(plant, context, numbers, setting.step) if sample and scene.floor else [])
        for body in scene.bodies:
            pose = plant.EvalBodyPoseInWorld(context, links[body.name])
            velocity = plant.EvalBodySpatialVelocityInWorld(context, links[body.name])
            numbers13 = (*pose.translation(), *pose.rotation().ToQuaternion().wxyz(), *velocity.translational(), *velocity.rotational())
            recorded.tracks[body.name].append([float(x) for x in numbers13])
    return recorded
