// How high levels may be set where targets are to be reached.

import { signal } from '../desk';

/** Of each lamp's flux, 1 to 10. */
export const most = signal(1);
