<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Numerics\DegreeTrigonometry;

/**
 * Sines and cosines of every latitude and longitude of an elevation grid. All of them are sines of (2k + 1) / (2 res)
 * degrees in the first quarter; each is computed when it is first needed.
 */
final class GridDirections
{
    /** @var array<int, float> */
    private array $sines = [];
    private readonly int $quarter;

    public function __construct(private readonly int $pixelsPerDegree)
    {
        $this->quarter = 90 * $pixelsPerDegree;
    }

    /**
     * The latitude of a line: 90 - (2 line + 1) / (2 res) degrees.
     *
     * @return array{float, float} sine and cosine
     */
    public function latitude(int $line): array
    {
        return $line < $this->quarter
            ? [$this->sine($this->quarter - 1 - $line), $this->sine($line)]
            : [-$this->sine($line - $this->quarter), $this->sine(2 * $this->quarter - 1 - $line)];
    }

    /**
     * The longitude of a sample: (2 sample + 1) / (2 res) degrees.
     *
     * @return array{float, float} sine and cosine
     */
    public function longitude(int $sample): array
    {
        $rising = $this->sine($sample % $this->quarter);
        $falling = $this->sine($this->quarter - 1 - $sample % $this->quarter);

        return match (intdiv($sample, $this->quarter)) {
            0 => [$rising, $falling],
            1 => [$falling, -$rising],
            2 => [-$rising, -$falling],
            default => [-$falling, $rising],
        };
    }

    private function sine(int $k): float
    {
        return $this->sines[$k] ??= DegreeTrigonometry::sin(2 * $k + 1, 2 * $this->pixelsPerDegree);
    }
}
