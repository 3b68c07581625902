<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

/** The radii of a whole Moon's elevation model. */
interface RadiusSource
{
    /** PRODUCT_ID of the model, as it stands in the patterns. */
    public function productId(): string;

    public function pixelsPerDegree(): int;

    /**
     * Reads a rectangle of samples.
     *
     * @param int $line    northernmost line, from 0
     * @param int $lines   number of lines
     * @param int $sample  westernmost sample, from 0, below 360 res
     * @param int $samples samples a line, which must not run over the prime meridian
     *
     * @return list<float> m, line by line from the north, in a line from the west
     */
    public function radii(int $line, int $lines, int $sample, int $samples): array;
}
