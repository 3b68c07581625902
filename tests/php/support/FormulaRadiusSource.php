<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

use Closure;
use Msisf\Scripts\Pattern\RadiusSource;

/** A Moon whose radius at a line and sample is a formula. */
final class FormulaRadiusSource implements RadiusSource
{
    /** @param Closure(int, int): float $radius of line and sample, m */
    public function __construct(private readonly int $pixelsPerDegree, private readonly Closure $radius)
    {
    }

    public function productId(): string
    {
        return 'TEST_GRID';
    }

    public function pixelsPerDegree(): int
    {
        return $this->pixelsPerDegree;
    }

    public function radii(int $line, int $lines, int $sample, int $samples): array
    {
        $radii = [];
        for ($row = $line; $row < $line + $lines; $row++) {
            for ($column = $sample; $column < $sample + $samples; $column++) {
                $radii[] = ($this->radius)($row, $column);
            }
        }

        return $radii;
    }
}
