using System;
using System.Runtime.InteropServices;

namespace Carom
{
    /// <summary>What was wrong, and what to do, in its text. Nothing has changed.</summary>
    public sealed class CaromException : Exception
    {
        public readonly int Code, Argument;  // Raw.CAROM_E_*; 1-based position in the C signature, 0: none in particular
        public readonly string Remedy;
        public readonly Vec3[] Witness;  // direction and point that prove a support function false, or null

        internal CaromException(int code, string message, string remedy) : base(message + ". Remedy: " + remedy) { Code = code; Remedy = remedy; }

        internal unsafe CaromException(int code, Error* e)
            : this(code, Marshal.PtrToStringUTF8((IntPtr)e->Message), Marshal.PtrToStringUTF8((IntPtr)e->Remedy))
        {
            Argument = e->Argument;
            Witness = e->HasWitness == 1 ? new[] { e->WitnessDir, e->WitnessOut } : null;
        }
    }

    /// <summary>For calls of Raw with an error: Call.Check(Raw.carom_body_wake(world, body.Handle, Call.Error)).</summary>
    public static unsafe class Call
    {
        private sealed class Room
        {
            internal readonly Error* Error = (Error*)Marshal.AllocHGlobal(sizeof(Error));
            internal Room() { Error->StructSize = (uint)sizeof(Error); }
            ~Room() { Marshal.FreeHGlobal((IntPtr)Error); }
        }

        [ThreadStatic] private static Room room;
        /// <summary>Of this thread: the library writes it on failure only.</summary>
        public static Error* Error => (room ?? (room = new Room())).Error;
        public static void Check(int result) { if (result != Raw.CAROM_OK) throw new CaromException(result, Error); }

        /// <summary>Where nothing is read or written: C refuses NULL.</summary>
        internal static void* Some(void* at) => at == null ? Error : at;
        internal static void Fits(string name, int length, int wanted, bool orNone)
        {
            if (length == wanted || orNone && length == 0) return;
            throw new CaromException(Raw.CAROM_E_OUT_OF_RANGE, $"{name} has {length} elements, not {wanted}", "give as many of each");
        }
    }
}
