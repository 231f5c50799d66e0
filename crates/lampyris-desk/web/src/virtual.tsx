// A list of rows of one height, of which those in sight are made.

import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';

export interface VirtualProps {
    count: number;
    height: number;
    row: (index: number) => ComponentChildren;
    label: string;
    /** The row that shall be brought into sight when it changes. */
    show?: number;
    role?: 'list' | 'rowgroup';
}

const SPARE = 4;

export function Virtual({ count, height, row, label, show, role = 'list' }: VirtualProps) {
    const box = useRef<HTMLDivElement>(null);
    const top = useSignal(0);
    const size = useSignal(600);
    useEffect(() => {
        const element = box.current as HTMLDivElement;
        const watch = new ResizeObserver(() => (size.value = element.clientHeight));
        watch.observe(element);
        return () => watch.disconnect();
    }, []);
    useEffect(() => {
        const element = box.current;
        if (!element || show === undefined || show < 0) return;
        const at = show * height;
        if (at < element.scrollTop || at + height > element.scrollTop + element.clientHeight) {
            element.scrollTop = Math.max(0, at - element.clientHeight / 2);
        }
    }, [show, height]);
    const first = Math.max(0, Math.floor(top.value / height) - SPARE);
    const last = Math.min(count, Math.ceil((top.value + size.value) / height) + SPARE);
    return (
        <div class="virtual" ref={box} tabIndex={count ? undefined : -1} onScroll={(e) => (top.value = e.currentTarget.scrollTop)}>
            <div class="all" role={role} aria-label={label} style={{ height: `${count * height}px` }}>
                <div class="rows" role="presentation" style={{ transform: `translateY(${first * height}px)` }}>
                    {Array.from({ length: Math.max(0, last - first) }, (_, k) => row(first + k))}
                </div>
            </div>
        </div>
    );
}
