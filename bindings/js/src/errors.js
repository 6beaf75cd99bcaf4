import * as constants from "./constants.js";

/** What a call that failed throws. The call changed nothing. */
export class CaromError extends Error {
  /** @param {{code: number, result: string, argument: number, text: string, remedy: string,
   *           witness: {direction: number[], point: number[]} | null}} details */
  constructor({ code, result, argument, text, remedy, witness }, doing) {
    super(`${doing ? doing + ": " : ""}${text}. ${remedy}`);
    this.name = "CaromError";
    this.code = code;
    this.result = result;
    this.argument = argument;
    this.text = text;
    this.remedy = remedy;
    this.witness = witness;
  }
}

/** What is not to be had here, said before the engine is asked.   @param argument  which is at fault, from 0 */
export function unsupported(doing, argument, text, remedy) {
  const result = "CAROM_E_UNSUPPORTED";
  return new CaromError({ code: constants[result], result, argument, text, remedy, witness: null }, doing);
}

/** A module that is none of ours.   @param file  as a person would name it */
export function cannotLoad(file, why, remedy) {
  const result = "CAROM_E_NOT_FOUND";
  const text = `cannot load ${file}: ${why}`;
  return new CaromError({ code: constants[result], result, argument: 1, text, remedy, witness: null });
}
