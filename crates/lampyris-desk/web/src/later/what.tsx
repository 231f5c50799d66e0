// «What lights this»: the share of every lamp at a point, direct, indirect and through glass or mirrors, each with its
// error. It gets better while it is open, and follows the lamps.

import {
    chosenLamps, closeWhat, digits, hovered, Icon, lamps, maintained, nameOf, select, useEffect, useRef, viewSize, what,
    type Share,
} from '../desk';
import { addMeter, aim } from './tools';

const total = (s: Share): number => s.direct[0] + s.indirect[0] + s.caustic[0];
const error = (s: Share): number => Math.hypot(s.direct[1], s.indirect[1], s.caustic[1]);

export function What() {
    const now = what.value;
    const box = useRef<HTMLDivElement>(null);
    useEffect(() => {
        if (now && box.current && !box.current.contains(document.activeElement)) box.current.focus();
    }, [now?.x, now?.y]);
    if (!now) return null;
    const [w, h] = viewSize.value;
    const rows = [...now.lamps].sort((a, b) => total(b) - total(a));
    const sum = rows.reduce((s, r) => s + total(r), 0) || 1;
    const shown = rows.slice(0, 9);
    const rest = sum - shown.reduce((s, r) => s + total(r), 0);
    const left = Math.max(8, Math.min(now.x + 12, w - 332));
    // As high as it is going to be, for it must not hang over the edge.
    const top = Math.max(8, Math.min(now.y + 12, h - 150 - 35 * shown.length));
    const title = now.lux ? `${maintained(now.lux[0])} ±${maintained(now.lux[1], false)}` : 'Measuring…';
    return (
        <div
            class="what sheetlet"
            role="dialog"
            aria-label="What lights this"
            tabIndex={-1}
            ref={box}
            style={{ left: `${left}px`, top: `${top}px` }}
            onKeyDown={(e) => {
                if (e.key !== 'Escape') return;
                e.stopPropagation();
                closeWhat();
                document.getElementById('view')?.focus();
            }}
            data-scroll
        >
            <header>
                <strong class={now.done ? '' : 'unsettled'}>{title}</strong>
                <span class="quiet">what lights this</span>
                <button class="icon" aria-label="Close" onClick={closeWhat}><Icon name="close" /></button>
            </header>
            <ol>
                {shown.map((share) => (
                    <li
                        key={share.id}
                        onPointerEnter={() => (hovered.value = { kind: 'lamp', id: share.id })}
                        onPointerLeave={() => (hovered.value = null)}
                    >
                        <button class="row" onClick={() => select('lamp', share.id)}>
                            <span class="name">{nameOf('lamp', share.id)}</span>
                            <span class="figure">{digits((100 * total(share)) / sum, total(share) / sum < 0.0995 ? 1 : 0)} %</span>
                            <span class="figure lux">{maintained(total(share))} ±{maintained(error(share), false)}</span>
                            <span class="shares" aria-hidden="true">
                                <i class="direct" style={{ width: `${(100 * share.direct[0]) / sum}%` }} />
                                <i class="indirect" style={{ width: `${(100 * share.indirect[0]) / sum}%` }} />
                                <i class="caustic" style={{ width: `${(100 * share.caustic[0]) / sum}%` }} />
                            </span>
                            <span class="spoken">
                                direct {maintained(share.direct[0])}, indirect {maintained(share.indirect[0])}, caustic{' '}
                                {maintained(share.caustic[0])}
                            </span>
                        </button>
                    </li>
                ))}
                {rows.length > shown.length && (
                    <li class="quiet">{rows.length - shown.length === 1 ? 'one more' : `${rows.length - shown.length} more together`}: {maintained(rest)}</li>
                )}
                {!rows.length && <li class="quiet">{now.done ? 'No lamp reaches this point.' : 'Gathering light…'}</li>}
            </ol>
            <footer>
                <span class="key direct">direct</span>
                <span class="key indirect">indirect</span>
                <span class="key caustic">caustic</span>
                <span class="gap" />
                {chosenLamps.value.some((id) => lamps.get(id)?.place?.direction) && (
                    <button onClick={() => aim(chosenLamps.peek(), now.hit.point)}>Aim here</button>
                )}
                <button onClick={() => addMeter(now.hit.point, now.hit.normal)}>Meter here</button>
            </footer>
        </div>
    );
}
