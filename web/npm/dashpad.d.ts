/** Impact of rigid bodies on foam pads. */

/** Something in the input that cannot be computed. */
export interface Fault {
  /** The case file, a card, or an option such as "--set". */
  file: string;
  /** null if unknown. */
  line: number | null;
  key: string;
  /** As written. */
  value: string;
  /** What would be right. */
  rule: string;
  /** The whole message, with the line of the file if there is one. */
  text: string;
}

/**
 * Thrown for input that cannot be computed: what a case, a card, a setting, a quantity or a limit says. An argument of a wrong
 * type or an unknown option is a mistake of the program and throws a TypeError.
 */
export class DashpadFaults extends Error {
  readonly faults: Fault[];
  /** The messages as the command shows them: many of one kind are abridged. */
  readonly lines: string[];
}

/** A value of a case file: a text with a unit, a number, or tables of them. */
export type CaseValue = string | number | boolean | CaseValue[] | { [key: string]: CaseValue };

/** The tables of a case file, or its text. */
export type Case = string | { [table: string]: CaseValue };

export type Units = "si" | "us" | "engineering-metric";

/** "KEY=VALUE" as of --set, or values by their keys: {"pad.thickness": "30 mm"}. */
export type Settings = string[] | { [key: string]: string | number };

export interface Options {
  settings?: Settings;
  /** Of texts and pages; results are in SI. Default: "si". */
  units?: Units;
  /** What is uncertain of foam and model, which takes further impacts. Default: true. */
  intervals?: boolean;
  /** Relative error allowed, from 1e-8 to 1e-2. Another number is a fault. */
  tolerance?: number;
  /** Name of a case given as text, for faults; files that it names are relative to its folder. Default: "case.toml". */
  file?: string;
  /** Files that the case names, by their paths. They stay with the engine. */
  files?: { [path: string]: string | Uint8Array };
}

/** A number in SI, or a text with its unit, such as "15 mph". */
export type Quantity = number | string;

export interface StandardOptions extends Options {
  /** Name of a standard, with its variants: "en-1078:kerbstone". */
  standard: string;
  mass?: Quantity;
  radius?: Quantity;
  speed?: Quantity;
  dropHeight?: Quantity;
  keepNose?: boolean;
  keepSpeed?: boolean;
}

export interface SolveForOptions extends Omit<StandardOptions, "standard"> {
  /** Limits to keep, those of a standard with its impactor; this or `until` is needed, or both. */
  standard?: string;
  /** A limit of your own on a figure of the case, as of --until: "peak_acceleration <= 80 g"; of several, all are to be kept. */
  until?: string | string[];
}

/** The figures of one impact, in SI units and g; the keys name the units. */
export interface Result {
  format: number;
  status: string;
  peak_force_N: number | null;
  peak_acceleration_g: number | null;
  peak_penetration_m: number | null;
  /** All others: schema/summary.schema.json. */
  [key: string]: unknown;
}

export interface Assessment {
  verdict: "pass" | "fail" | "undecided";
  /** A pass without reservations. */
  unqualified: boolean;
  criteria: { [key: string]: unknown }[];
  /** Figures of the impact by their keys. */
  figures: { [key: string]: unknown };
  result: Result;
  [key: string]: unknown;
}

/** A value at which the verdict turns, in the SI unit of the key; null where the range has no end of its interval. */
export interface Turn {
  value: number;
  low: number | null;
  high: number | null;
  passes_above: boolean;
  jumps: boolean;
  figure: string;
  [key: string]: unknown;
}

export interface SolveForAnswer {
  /** One sentence. */
  answer: string;
  turns: Turn[];
  stretches: { from: number; to: number; verdict: "pass" | "fail" | "undecided" | "unknown" }[];
  complete: boolean;
  [key: string]: unknown;
}

export interface MaterialEntry {
  name: string;
  title: string;
}

export interface StandardEntry {
  name: string;
  title: string;
  variants: string[];
  /** One for each variant; "" where there is none. */
  variant_titles: string[];
}

export class Engine {
  private constructor();
  /** As `dashpad assess --json` writes it. */
  solve(given: Case, options: StandardOptions): Assessment;
  /** As `dashpad run --json` writes it. */
  solve(given: Case, options?: Options): Result;
  assess(given: Case, options: StandardOptions): Assessment;
  /** The values of a number of the case, such as "pad.thickness", at which the verdict turns. */
  solveFor(key: string, given: Case, options: SolveForOptions): SolveForAnswer;
  /** The case in SI as it is read: as `dashpad check --json` writes it. */
  check(given: Case, options?: Options): { [key: string]: unknown };
  /** The answer as one HTML file. */
  page(given: Case, options?: Options | StandardOptions): string;
  /** The answer as on a terminal; `all` for every figure with its error. */
  text(given: Case, options?: (Options | StandardOptions) & { all?: boolean }): string;
  materials(): MaterialEntry[];
  standards(): StandardEntry[];
  /** A file that cases may name, or a card ("materials/NAME.toml") or a standard ("standards/NAME.toml"). */
  addFile(path: string, content: string | Uint8Array): void;
}

export interface LoadOptions {
  /** The engine, packed by gzip or not, or in browsers where it is. Default: beside the package. */
  wasm?: URL | string | ArrayBuffer | Uint8Array | WebAssembly.Module;
  files?: { [path: string]: string | Uint8Array };
}

export function loadEngine(options?: LoadOptions): Promise<Engine>;
