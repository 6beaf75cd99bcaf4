// Who frees what. `free()` is the way; what a program forgot is freed when the garbage collector finds it.

/** What stands behind an Engine or a World: a pointer, and how it is destroyed. An engine that is found first waits
 * for its worlds. */
export class Owned {
  constructor(pointer, destroy, parent = null) {
    Object.assign(this, { pointer, destroy, parent, children: 0, forgotten: false });
    if (parent) ++parent.children;
  }

  release() {
    if (!this.pointer) return;
    this.destroy(this.pointer);
    this.pointer = 0;
    if (!this.parent) return;
    if (--this.parent.children === 0 && this.parent.forgotten) this.parent.release();
  }

  forget() {
    this.forgotten = true;
    if (this.children === 0) this.release();
  }
}

export const net = new FinalizationRegistry((owned) => owned.forget());
