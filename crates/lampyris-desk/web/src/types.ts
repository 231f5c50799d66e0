// What the wire carries (docs/wire.md), as types. Metres, degrees, lumens, lux; colours are linear Rec. 709.

export type Vec = [number, number, number];
/** A value and its error of 95 % confidence. */
export type Measured = [number, number];
export type Id = number;

export interface Camera {
    name?: string;
    eye: Vec;
    target: Vec;
    up: Vec;
    /** Vertical field of view [degrees]. */
    fov: number;
    /** What is to be seen from below to above [m]; makes the camera orthographic. */
    height?: number | null;
    /** What is nearer to the eye's plane [m] is hidden from the eye. */
    near?: number | null;
}

export interface Box {
    low: Vec;
    high: Vec;
}

export type ColorMode = 'file' | 'kelvin' | 'rgb' | 'xy';

export interface Color {
    mode: ColorMode;
    kelvin: number;
    /** Duv × 1000. */
    tint: number;
    rgb: Vec;
    xy: [number, number];
}

export type LampKind = 'surface' | 'point' | 'spot' | 'parallel' | 'sphere' | 'disc' | 'sky';

export interface Place {
    position?: Vec | null;
    direction?: Vec | null;
    /** The point that a lamp looks at while it is moved. */
    aim?: Vec | null;
    radius?: number | null;
    inner?: number | null;
    outer?: number | null;
    /** Of a thing or a luminous surface, about its middle: a quaternion x y z w, and a factor. */
    rotation?: [number, number, number, number] | null;
    scale?: number | null;
}

export interface Lamp {
    name: string;
    kind: LampKind;
    on: boolean;
    level: number;
    color: Color;
    flux: number;
    swatch: Vec;
    group: Id | null;
    layer: number | null;
    free: boolean;
    parked: boolean;
    own: boolean;
    place: Place | null;
    box: [Vec, Vec] | null;
}

export interface Group {
    name: string;
    on: boolean;
    level: number;
    lamps: Id[];
}

export interface Layer {
    name: string;
    batches: number;
    of: number;
    held: boolean;
}

export interface Thing {
    name: string;
    place: Place | null;
    hidden: boolean;
    box: [Vec, Vec] | null;
    materials: Id[];
    locked: boolean;
}

export interface Material {
    name: string;
    kind: string;
    color?: Vec | null;
    transmittance?: Vec | null;
    reflectance: number | null;
    roughness?: number | null;
    specular?: number | null;
}

export interface Look {
    name: string;
    picture: string | null;
}

export interface Meter {
    name: string;
    kind: 'surface' | 'horizontal' | 'vertical' | 'cylindrical' | 'camera';
    point: Vec;
    normal: Vec;
    lux?: Measured | null;
    /** How much more than in the look that is compared with [lx]; so it is with areas. */
    change?: number | null;
    /** No batch will change it. */
    done?: boolean;
    /** What it shall read at least [lx]. */
    target?: number | null;
}

export interface Grid {
    name: string;
    corner: Vec;
    u: Vec;
    v: Vec;
    normal: Vec;
    columns: number;
    rows: number;
    /** What is left off along edges that are longer than two of it [m]. */
    border?: number;
    /** Row by row, as far as it is known; so are the figures. */
    lux?: (number | null)[];
    mean?: number | null;
    change?: number | null;
    min?: number | null;
    max?: number | null;
    uniformity?: number | null;
    /** ± of the mean [lx], and of the uniformity. */
    error?: number | null;
    uniformity_error?: number | null;
    /** No batch will change them. */
    done?: boolean;
    target?: { lux: number; uniformity: number } | null;
}

export interface FalseColor {
    /** A difference is one of illuminance, to a look; clamped is a share in percent. */
    quantity: 'illuminance' | 'luminance' | 'difference' | 'clamped';
    against?: Id | null;
    low: number;
    high: number;
    scale: 'log' | 'linear';
    palette: string;
    lines: boolean;
    /** The program's: colours from low to high, palettes that there are, ticks and where they stand, 0 to 1. */
    colors?: string[];
    palettes?: string[];
    ticks?: [number, number][];
    /** False where lamps that differ in the look share a layer. */
    exact?: boolean;
}

export interface Display {
    ev: number | null;
    /** True where the exposure is the one that was metered. */
    metered: boolean;
    tone: string;
    white: { kelvin: number; tint: number } | null;
    false_color: FalseColor | null;
}

export interface Scene {
    name: string;
    file: string;
    up: Vec;
    bounds: [Vec, Vec];
    triangles: number;
    cameras: Camera[];
    warnings: string[];
}

export interface Status {
    fps?: number;
    batches?: number;
    error?: number | null;
    good_in?: number | null;
    size?: [number, number];
    stage: 'loading' | 'moving' | 'refining' | 'good' | 'done';
}

export interface History {
    undo: string | null;
    redo: string | null;
    steps: number;
}

export interface Saved {
    state: 'clean' | 'saved' | 'waiting' | 'failed';
    file: string | null;
    why?: string | null;
}

/** What the server answers to `point`. */
export interface Hit {
    hit: boolean;
    point: Vec;
    normal: Vec;
    thing: Id | null;
    material: Id | null;
    lamp: Id | null;
    lux: Measured | null;
    luminance: Measured | null;
    /** How much more than in the look that is compared with [lx]. */
    change?: number | null;
}

/** One lamp's part of the light at a point, each [lx, ±]. */
export interface Share {
    id: Id;
    direct: Measured;
    indirect: Measured;
    caustic: Measured;
}

export interface LinkEntry {
    id: Id;
    role: 'edit' | 'watch';
    address: string;
}

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
/** An edit in the shape of the state. */
export type Patch = Record<string, unknown>;
