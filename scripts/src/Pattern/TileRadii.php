<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

/** The radii of a tile's vertices, in m. */
final class TileRadii
{
    /**
     * @param ?float $northPole mean radius of the first line, if the mesh reaches the pole
     * @param ?float $southPole mean radius of the last line, likewise
     */
    public function __construct(
        public readonly TileMeshLayout $layout,
        private readonly SampleBlock $block,
        public readonly ?float $northPole,
        public readonly ?float $southPole,
    ) {
    }

    /**
     * One line of the layout.
     *
     * @param int $row from 0, northernmost
     *
     * @return list<float>
     */
    public function row(int $row): array
    {
        return $this->block->line($this->layout->firstLine + $row, $this->layout->firstSample, $this->layout->samples);
    }

    /** SHA-256 over the radii as little-endian doubles in vertex order, in small hexadecimal digits. */
    public function hash(): string
    {
        $hash = hash_init('sha256');
        hash_update($hash, $this->northPole === null ? '' : pack('e', $this->northPole));
        for ($row = 0; $row < $this->layout->lines; $row++) {
            hash_update($hash, pack('e*', ...$this->row($row)));
        }
        hash_update($hash, $this->southPole === null ? '' : pack('e', $this->southPole));

        return hash_final($hash);
    }
}
