<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

/** Radii of a rectangle of samples, read at once; it may run over the prime meridian. */
final class SampleBlock
{
    /**
     * @param list<array{int, int, list<float>}> $strips first sample, samples a line, radii; from west to east
     */
    private function __construct(private readonly int $firstLine, private readonly array $strips)
    {
    }

    /** @param int $samples samples a line; those beyond the last one go on with the first */
    public static function read(RadiusSource $source, int $line, int $lines, int $sample, int $samples): self
    {
        $before = min($samples, 360 * $source->pixelsPerDegree() - $sample);
        $strips = [[$sample, $before, $source->radii($line, $lines, $sample, $before)]];
        if ($before < $samples) {
            $strips[] = [0, $samples - $before, $source->radii($line, $lines, 0, $samples - $before)];
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
            $part = array_slice($radii, $row * $width + $firstSample - $first, min($samples, $first + $width - $firstSample));
            if (count($part) < $samples) {
                [, $nextWidth, $nextRadii] = $this->strips[$index + 1];
                array_push($part, ...array_slice($nextRadii, $row * $nextWidth, $samples - count($part)));
            }

            return $part;
        }

        throw new \LogicException("Sample $firstSample of line $line was not read.");
    }
}
