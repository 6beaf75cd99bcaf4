using System;
using System.Runtime.InteropServices;

namespace Carom
{
    /// <summary>What was wrong, and what to do, in its text. Nothing has changed.</summary>
    public sealed class CaromException : Exception
    {
        /// <summary>Raw.CAROM_E_*</summary>
        public readonly int Code;
        /// <summary>1-based position of the argument at fault in the C signature, 0: none in particular</summary>
        public readonly int Argument;
        public readonly string Remedy;
        /// <summary>Direction and point that prove a support function false, or null</summary>
        public readonly Vec3[] Witness;

        internal CaromException(int code, string message, string remedy) : base(message + ". Remedy: " + remedy)
        {
            Code = code;
            Remedy = remedy;
        }

        internal unsafe CaromException(int code, Error* e) : this(code, Text(e->Message), Text(e->Remedy))
        {
            Argument = e->Argument;
            Witness = e->HasWitness == 1 ? new[] { e->WitnessDir, e->WitnessOut } : null;
        }

        private static unsafe string Text(byte* at) { return Marshal.PtrToStringUTF8((IntPtr)at); }
    }

    /// <summary>For calls of Raw: Call.Check(Raw.carom_body_wake(world, body.Handle, Call.Error)).</summary>
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
        public static Error* Error { get { return (room ?? (room = new Room())).Error; } }

        public static void Check(int result)
        {
            if (result != Raw.CAROM_OK) throw new CaromException(result, Error);
        }
    }
}
