// A sign of the sprite `icons.svg`; words are always beside it or in the label of its button.

export function Icon({ name }: { name: string }) {
    return (
        <svg class="sign" aria-hidden="true" width="16" height="16">
            <use href={`icons.svg#${name}`} />
        </svg>
    );
}
