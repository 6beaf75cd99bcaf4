namespace Carom
{
    /// <summary>A body of a world, by its handle, which the library validates in every call; forgetting one destroys nothing.</summary>
    public readonly unsafe struct Body
    {
        public readonly World World;
        public readonly ulong Handle;

        public Body(World world, ulong handle) { World = world; Handle = handle; }

        public Vec3 Position
        {
            get
            {
                Vec3 p;
                Call.Check(Raw.carom_body_get_pose(World, Handle, (double*)&p, null, Call.Error));
                return p;
            }
        }

        public Pose Pose
        {
            get
            {
                Pose pose = default(Pose);
                Call.Check(Raw.carom_body_get_pose(World, Handle, (double*)&pose.Position, (double*)&pose.Orientation, Call.Error));
                return pose;
            }
            set { Call.Check(Raw.carom_body_set_pose(World, Handle, (double*)&value.Position, (double*)&value.Orientation, Call.Error)); }
        }

        /// <summary>m/s, of the centre of mass</summary>
        public Vec3 LinearVelocity
        {
            get
            {
                Vec3 v;
                Call.Check(Raw.carom_body_get_velocity(World, Handle, (double*)&v, null, Call.Error));
                return v;
            }
        }

        /// <param name="linear">m/s, of the centre of mass</param>
        /// <param name="angular">rad/s</param>
        public void SetVelocity(Vec3 linear, Vec3 angular)
        {
            Call.Check(Raw.carom_body_set_velocity(World, Handle, (double*)&linear, (double*)&angular, Call.Error));
        }

        /// <summary>For the next step.</summary>
        /// <param name="force">N</param>
        /// <param name="torque">N m</param>
        public void AddForce(Vec3 force, Vec3 torque)
        {
            Call.Check(Raw.carom_body_add_force(World, Handle, (double*)&force, (double*)&torque, Call.Error));
        }

        public void Destroy() { Call.Check(Raw.carom_body_destroy(World, Handle, Call.Error)); }
    }
}
