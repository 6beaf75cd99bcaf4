using System;
using Microsoft.Win32.SafeHandles;

namespace Carom
{
    /// <summary>A record of Raw.CAROM_FIELD_POSE.</summary>
    public struct Pose
    {
        public Vec3 Position;
        public Quat Orientation;
        public Pose(Vec3 position, Quat orientation) { Position = position; Orientation = orientation; }
    }

    /// <summary>A body of a world, by its handle, which the library validates in every call; forgetting one destroys nothing.</summary>
    public readonly struct Body
    {
        public readonly World World;
        public readonly ulong Handle;
        public Body(World world, ulong handle) { World = world; Handle = handle; }

        public unsafe Vec3 Position { get { Vec3 p; Call.Check(Raw.carom_body_get_pose(World, Handle, (double*)&p, null, Call.Error)); return p; } }
        public Pose Pose
        {
            get { var (position, orientation) = Raw.carom_body_get_pose(World, Handle); return new Pose(position, orientation); }
            set { Raw.carom_body_set_pose(World, Handle, value.Position, value.Orientation); }
        }
        /// <summary>m/s, of the centre of mass</summary>
        public Vec3 LinearVelocity => Raw.carom_body_get_velocity(World, Handle).linear;
        /// <summary>m/s, of the centre of mass; rad/s</summary>
        public void SetVelocity(Vec3 linear, Vec3 angular) => Raw.carom_body_set_velocity(World, Handle, linear, angular);
        /// <summary>For the next step: N, N m.</summary>
        public void AddForce(Vec3 force, Vec3 torque) => Raw.carom_body_add_force(World, Handle, force, torque);
        public void Destroy() => Raw.carom_body_destroy(World, Handle);
    }

    /// <summary>Bodies and what acts on them. Any number of threads may read it; beside one that changes it others get CAROM_E_BUSY.
    /// A material or joint is a handle.</summary>
    public sealed class World : SafeHandleZeroOrMinusOneIsInvalid
    {
        public readonly Engine Engine;

        internal World(Engine engine, IntPtr pointer) : base(true)
        {
            bool kept = false;
            engine.DangerousAddRef(ref kept);  // given back with the world: the engine goes last
            Engine = engine;
            SetHandle(pointer);
        }

        protected override unsafe bool ReleaseHandle()
        {
            try { return Raw.carom_world_destroy(handle, null) == Raw.CAROM_OK; }
            finally { Engine.DangerousRelease(); }
        }

        /// <summary>Advance by dt, s.</summary>
        public void Step(double dt) => Raw.carom_world_step(this, dt);
        /// <param name="dial">Raw.CAROM_DIAL_*</param>
        public void SetDial(uint dial, double value) => Raw.carom_world_set_dial(this, dial, value);
        /// <summary>Of all that a step changes: to compare two runs.</summary>
        public ulong Hash() => Raw.carom_world_hash(this);

        public ulong Material(double friction, double restitution)
        {
            MaterialDesc desc = MaterialDesc.New();
            (desc.Friction, desc.Restitution) = (friction, restitution);
            return Raw.carom_material_create(this, desc);
        }

        /// <summary>A dynamic body of one shape, of density 1000 kg/m^3.</summary>
        public Body Body(ulong shape, Vec3 position) => Body(shape, position, Raw.CAROM_BODY_DYNAMIC);
        /// <summary>A static half-space below height, m.</summary>
        public Body Ground(double height) => Body(Engine.Shape("half_space", 0, 1, 0, height), new Vec3(0, 0, 0), Raw.CAROM_BODY_STATIC);

        private Body Body(ulong shape, Vec3 position, uint type)
        {
            BodyDesc desc = BodyDesc.New();
            (desc.Type, desc.Position) = (type, position);
            ColliderDesc part = ColliderDesc.New();
            part.Shape = shape;
            return Body(desc, part);
        }

        /// <summary>A body of any number of shapes.</summary>
        public Body Body(BodyDesc desc, params ColliderDesc[] parts)
        {
            var made = new Body(this, Raw.carom_body_create(this, desc));
            try { foreach (ColliderDesc part in parts) Raw.carom_collider_create(this, made.Handle, part); }
            catch { made.Destroy(); throw; }
            return made;
        }

        public ulong Joint(JointDesc desc) => Raw.carom_joint_create(this, desc);
        /// <summary>Handles of all bodies.</summary>
        public ulong[] Bodies() => Raw.carom_world_get_bodies(this);
        /// <summary>Contact points of the last step.</summary>
        public Contact[] Contacts() => Raw.carom_world_get_contacts(this);

        /// <summary>One field (Raw.CAROM_FIELD_*) of some bodies or, where these are none, of all in the order of Bodies(). A record T is of
        /// doubles: Vec3, Quat, Pose, or a struct of your own.</summary>
        public void Read<T>(uint field, ReadOnlySpan<ulong> bodies, Span<T> to) where T : struct =>
            Raw.carom_world_read(this, field, Raw.CAROM_SCALAR_F64, bodies, to);
        public void Write<T>(uint field, ReadOnlySpan<ulong> bodies, ReadOnlySpan<T> from) where T : struct =>
            Raw.carom_world_write(this, field, Raw.CAROM_SCALAR_F64, bodies, from);
        /// <summary>Of all bodies, in the order of Bodies().</summary>
        public void Positions(Span<Vec3> to) => Read(Raw.CAROM_FIELD_POSITION, default(ReadOnlySpan<ulong>), to);
        public void Poses(Span<Pose> to) => Read(Raw.CAROM_FIELD_POSE, default(ReadOnlySpan<ulong>), to);

        /// <param name="flags">Raw.CAROM_SNAPSHOT_*</param>
        public byte[] Save(uint flags) => Raw.carom_world_save(this, flags);
        public void Restore(ReadOnlySpan<byte> bytes) => Raw.carom_world_restore(this, bytes);
        /// <summary>A copy that goes on bit for bit as this world does. Dispose it, too.</summary>
        public World Fork() => new World(Engine, Raw.carom_world_fork(this));
    }
}
