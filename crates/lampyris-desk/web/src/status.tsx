// The line at the bottom: how good the picture is, how fast, and what is under the pointer.

import { computed } from '@preact/signals';
import { rate, shown } from './frames';
import { counters } from './counters';
import { editor, layers, status } from './store';
import { state } from './states';
import { digits } from './units';
import { probe, probeText } from './probe';
import { line, me } from './wire';

/** Median of the latest answers: from the event to the paint of the first frame with it [ms]. */
const latency = computed(() => {
    void shown.value;
    const times: number[] = [];
    for (const sent of counters.sent.slice(-24)) {
        if (sent.what !== 'set' && sent.what !== 'camera') continue;
        const frame = counters.frames.find((f) => f.seq >= sent.seq && f.painted);
        if (frame && frame.painted > sent.at) times.push(frame.painted - (sent.input || sent.at));
    }
    times.sort((a, b) => a - b);
    return times.length ? times[times.length >> 1] : null;
});

function quality(): string {
    const s = status.value;
    if (!s) return 'starting';
    const off = s.error == null ? '' : ` ±${digits((s.error ?? 0) * 100, s.error < 0.0995 ? 1 : 0)} %`;
    switch (s.stage) {
        case 'loading':
            return 'first look';
        case 'moving':
            return `moving${off}`;
        case 'refining':
            return `${off.trim() || 'refining'}${s.good_in ? `, good in ${digits(s.good_in, s.good_in < 3 ? 1 : 0)} s` : ''}`;
        case 'good':
            return `good${off}`;
        case 'done':
            return `finished${off}`;
    }
}

export function StatusLine() {
    const s = status.value;
    const head = shown.value?.head;
    const busy = layers.value.filter((layer) => layer.batches < layer.of && !layer.held).length;
    const ahead = s?.stage === 'refining' && s.good_in ? Math.max(0.02, 1 / (1 + s.good_in)) : s?.stage === 'good' || s?.stage === 'done' ? 1 : 0.02;
    return (
        <footer class="status" aria-label="Status">
            <span class={`quality ${s?.stage ?? ''}`}>
                <i class="thin" aria-hidden="true"><b style={{ width: `${ahead * 100}%` }} /></i>
                {quality()}
            </span>
            <span>{digits(head?.batches ?? s?.batches ?? 0)} batches</span>
            <span>{line.value === 'open' ? `${digits(rate.value)} fps` : 'no line'}</span>
            {latency.value !== null && <span title="From the hand to the paint, median">{digits(latency.value)} ms</span>}
            {head && <span>{head.width} × {head.height}</span>}
            <span class="wide">{layers.value.length} layers{busy ? `, ${busy} tracing` : ''}</span>
            <span class="probe" aria-live="off">{probeText(probe.value)}</span>
            <span class="gap" />
            <span>{editor.value.you ? 'editing: you' : `editing: ${editor.value.name ?? 'somebody else'}`}</span>
            <span class="spoken">{me.value ?? ''} {state.value}</span>
        </footer>
    );
}
