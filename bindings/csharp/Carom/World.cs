using System;
using System.Runtime.InteropServices;
using static Carom.Call;

namespace Carom
{
    /// <summary>A body of a world, by its handle, which the library validates in every call; forgetting one destroys nothing.</summary>
    public readonly unsafe struct Body
    {
        public readonly World World;
        public readonly ulong Handle;
        public Body(World world, ulong handle) { World = world; Handle = handle; }

        public Vec3 Position { get { Vec3 p; Check(Raw.carom_body_get_pose(World, Handle, (double*)&p, null, Call.Error)); return p; } }
        public Pose Pose
        {
            get { Pose p = default(Pose); Check(Raw.carom_body_get_pose(World, Handle, (double*)&p.Position, (double*)&p.Orientation, Call.Error)); return p; }
            set { Check(Raw.carom_body_set_pose(World, Handle, (double*)&value.Position, (double*)&value.Orientation, Call.Error)); }
        }
        /// <summary>m/s, of the centre of mass</summary>
        public Vec3 LinearVelocity { get { Vec3 v; Check(Raw.carom_body_get_velocity(World, Handle, (double*)&v, null, Call.Error)); return v; } }
        /// <summary>m/s, of the centre of mass; rad/s</summary>
        public void SetVelocity(Vec3 linear, Vec3 angular) =>
            Check(Raw.carom_body_set_velocity(World, Handle, (double*)&linear, (double*)&angular, Call.Error));
        /// <summary>For the next step: N, N m.</summary>
        public void AddForce(Vec3 force, Vec3 torque) => Check(Raw.carom_body_add_force(World, Handle, (double*)&force, (double*)&torque, Call.Error));
        public void Destroy() => Check(Raw.carom_body_destroy(World, Handle, Call.Error));
    }

    /// <summary>Bodies and what acts on them. Any number of threads may read it; beside one that changes it others get CAROM_E_BUSY.</summary>
    public sealed unsafe class World : SafeHandle
    {
        public readonly Engine Engine;

        internal World(Engine engine, IntPtr pointer) : base(IntPtr.Zero, true)
        {
            bool kept = false;
            engine.DangerousAddRef(ref kept);  // given back with the world: the engine goes last
            Engine = engine;
            SetHandle(pointer);
        }

        [DllImport(Raw.File, CallingConvention = CallingConvention.Cdecl)]
        private static extern int carom_world_destroy(IntPtr world, Error* error);
        public override bool IsInvalid => handle == IntPtr.Zero;
        protected override bool ReleaseHandle()
        {
            bool done = carom_world_destroy(handle, null) == Raw.CAROM_OK;
            Engine.DangerousRelease();
            return done;
        }

        /// <summary>Advance by dt, s.</summary>
        public void Step(double dt) => Check(Raw.carom_world_step(this, dt, Call.Error));
        /// <param name="dial">Raw.CAROM_DIAL_*</param>
        public void SetDial(uint dial, double value) => Check(Raw.carom_world_set_dial(this, dial, value, Call.Error));
        /// <summary>Of all that a step changes: to compare two runs.</summary>
        public ulong Hash() { ulong hash; Check(Raw.carom_world_hash(this, &hash, Call.Error)); return hash; }

        /// <returns>a handle</returns>
        public ulong Material(double friction, double restitution)
        {
            MaterialDesc desc = MaterialDesc.New();
            desc.Friction = friction;
            desc.Restitution = restitution;
            ulong material;
            Check(Raw.carom_material_create(this, &desc, &material, Call.Error));
            return material;
        }

        /// <summary>A dynamic body of one shape, of density 1000 kg/m^3.</summary>
        public Body Body(ulong shape, Vec3 position)
        {
            BodyDesc desc = BodyDesc.New();
            desc.Position = position;
            return Body(desc, Part(shape));
        }

        /// <summary>A static half-space below height, m.</summary>
        public Body Ground(double height)
        {
            BodyDesc desc = BodyDesc.New();
            desc.Type = Raw.CAROM_BODY_STATIC;
            return Body(desc, Part(Engine.Shape("half_space", 0, 1, 0, height)));
        }

        private static ColliderDesc Part(ulong shape) { ColliderDesc part = ColliderDesc.New(); part.Shape = shape; return part; }

        /// <summary>A body of any number of shapes.</summary>
        public Body Body(BodyDesc desc, params ColliderDesc[] parts)
        {
            ulong made, collider;
            Check(Raw.carom_body_create(this, &desc, &made, Call.Error));
            fixed (ColliderDesc* part = parts)
                for (int i = 0; i < parts.Length; i++)
                {
                    int result = Raw.carom_collider_create(this, made, part + i, &collider, Call.Error);
                    if (result != Raw.CAROM_OK) Raw.carom_body_destroy(this, made, null);
                    Check(result);
                }
            return new Body(this, made);
        }

        /// <returns>a handle</returns>
        public ulong Joint(JointDesc desc) { ulong joint; Check(Raw.carom_joint_create(this, &desc, &joint, Call.Error)); return joint; }

        /// <summary>Handles of all bodies.</summary>
        public ulong[] Bodies()
        {
            ulong count = 0;
            Check(Raw.carom_world_get_bodies(this, null, 0, &count, Call.Error));
            var all = new ulong[count];
            fixed (ulong* to = all) Check(Raw.carom_world_get_bodies(this, to, count, &count, Call.Error));
            return all;
        }

        /// <summary>Contact points of the last step.</summary>
        public Contact[] Contacts()
        {
            ulong count = 0;
            Check(Raw.carom_world_get_contacts(this, null, (ulong)sizeof(Contact), 0, &count, Call.Error));
            var all = new Contact[count];
            fixed (Contact* to = all) Check(Raw.carom_world_get_contacts(this, to, (ulong)sizeof(Contact), count, &count, Call.Error));
            return all;
        }

        private static readonly int[] Width = { 3, 4, 7, 3, 3, 6, 6, 3, 1 };  // numbers a body, by field: carom/body_bulk.h

        private static ulong Count(uint field, int bodies, int numbers)
        {
            int width = field < Width.Length ? Width[field] : 1;  // one that there is not the library names
            if (numbers % width == 0 && (bodies == 0 || numbers / width == bodies)) return (ulong)(numbers / width);
            throw new CaromException(Raw.CAROM_E_OUT_OF_RANGE, $"{numbers} numbers, {width} a body" + (bodies > 0 ? $", for {bodies} bodies" : ""),
                "pass as many numbers as the field has for as many bodies");
        }

        /// <summary>One field (Raw.CAROM_FIELD_*) of some bodies or, where these are none, of all in the order of Bodies().</summary>
        public void Read(uint field, ReadOnlySpan<ulong> bodies, Span<double> to)
        {
            ulong n = Count(field, bodies.Length, to.Length);
            fixed (ulong* b = bodies)
            fixed (double* p = to) Check(Raw.carom_world_read(this, field, Raw.CAROM_SCALAR_F64, b, n, p, 0, Call.Error));
        }

        public void Write(uint field, ReadOnlySpan<ulong> bodies, ReadOnlySpan<double> from)
        {
            ulong n = Count(field, bodies.Length, from.Length);
            fixed (ulong* b = bodies)
            fixed (double* p = from) Check(Raw.carom_world_write(this, field, Raw.CAROM_SCALAR_F64, b, n, p, 0, Call.Error));
        }

        /// <summary>Of all bodies, in the order of Bodies().</summary>
        public void Positions(Span<Vec3> to) => Read(Raw.CAROM_FIELD_POSITION, default(ReadOnlySpan<ulong>), MemoryMarshal.Cast<Vec3, double>(to));
        /// <summary>Of all bodies, in the order of Bodies().</summary>
        public void Poses(Span<Pose> to) => Read(Raw.CAROM_FIELD_POSE, default(ReadOnlySpan<ulong>), MemoryMarshal.Cast<Pose, double>(to));

        /// <param name="flags">Raw.CAROM_SNAPSHOT_*</param>
        public byte[] Save(uint flags)
        {
            ulong size = 0;
            Check(Raw.carom_world_save(this, flags, null, 0, &size, Call.Error));
            var bytes = new byte[size];
            fixed (byte* to = bytes) Check(Raw.carom_world_save(this, flags, to, size, &size, Call.Error));
            return bytes;
        }

        public void Restore(ReadOnlySpan<byte> bytes) { fixed (byte* from = bytes) Check(Raw.carom_world_restore(this, from, (ulong)bytes.Length, Call.Error)); }

        /// <summary>A copy that goes on bit for bit as this world does. Dispose it, too.</summary>
        public World Fork() { IntPtr copy; Check(Raw.carom_world_fork(this, &copy, Call.Error)); return new World(Engine, copy); }
    }
}
