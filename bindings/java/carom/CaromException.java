package carom;

/** What was wrong, and what to do, in its text. Nothing has changed. */
@SuppressWarnings("serial")
public final class CaromException extends RuntimeException {
    /** Raw.CAROM_E_* */
    public final int code;
    /** 1-based position of the argument at fault in the C signature, 0: none in particular */
    public final int argument;
    public final String remedy;
    /** Direction and point that prove a support function false, or null */
    public final Vec3[] witness;

    CaromException(int code, String message, String remedy) {
        super(message + ". Remedy: " + remedy);
        this.code = code;
        this.remedy = remedy;
        argument = 0;
        witness = null;
    }

    CaromException(int code, Raw.Error e) {
        super(e.message() + ". Remedy: " + e.remedy());
        this.code = code;
        remedy = e.remedy();
        argument = e.argument();
        witness = e.hasWitness() == 1 ? new Vec3[] {Vec3.of(e.witnessDir()), Vec3.of(e.witnessOut())} : null;
    }
}
