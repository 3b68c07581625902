<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use LogicException;

/** Radii of a rectangle of samples, read at once; it may run over the prime meridian. */
final class SampleBlock
{
    /**
     * @param list<array{int, int, list<float>}> $strips first sample, samples a line, radii; each goes on with the next,
     *                                                   the last with the first
     */
    private function __construct(private readonly int $firstLine, private readonly array $strips)
    {
    }

    /** @param int $samples samples a line; those beyond the last one go on with the first */
    public static function read(RadiusSource $source, int $line, int $lines, int $sample, int $samples): self
    {
        $all = 360 * $source->pixelsPerDegree();
        $ranges = match (true) {
            $samples >= $all => [[0, $all]],
            $sample + $samples > $all => [[$sample, $all - $sample], [0, $sample + $samples - $all]],
            default => [[$sample, $samples]],
        };
        $strips = [];
        foreach ($ranges as [$first, $width]) {
            $strips[] = [$first, $width, $source->radii($line, $lines, $first, $width)];
        }

        return new self($line, $strips);
    }

    /**
     * The radii of a part of a line that was read.
     *
     * @return list<float> m
     */
    public function line(int $line, int $firstSample, int $samples): array
    {
        $row = $line - $this->firstLine;
        foreach ($this->strips as $index => [$first, $width, $radii]) {
            if ($firstSample < $first || $firstSample >= $first + $width) {
                continue;
            }
            $before = min($samples, $first + $width - $firstSample);
            $part = array_slice($radii, $row * $width + $firstSample - $first, $before);
            if ($before < $samples) {
                [, $nextWidth, $nextRadii] = $this->strips[($index + 1) % count($this->strips)];
                array_push($part, ...array_slice($nextRadii, $row * $nextWidth, $samples - $before));
            }

            return $part;
        }

        throw new LogicException("Sample $firstSample of line $line was not read.");
    }
}
