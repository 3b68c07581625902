<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Exception\UsageException;

/** What patterns are wanted. */
final class PatternOptions
{
    /** Degrees: far more than any margin needs, and what fits the tile's lattice. */
    private const GREATEST_MARGIN_DEGREES = 1.0;

    private function __construct(private readonly float $marginDegrees, public readonly PatternFormat $format)
    {
    }

    /** @param string $margin overlap with the neighbours on each side, degrees (thesis: 0.5 at 4 and 16 px/deg, 0.1 at 64) */
    public static function parse(string $margin, PatternFormat $format): self
    {
        $isNumber = preg_match('/^\+?(?:\d+(?:\.\d*)?|\.\d+)$/D', $margin) === 1;
        if (!$isNumber || (float) $margin > self::GREATEST_MARGIN_DEGREES) {
            throw UsageException::badValue('margin', $margin, 'degrees from 0 (tiles meet without one) to 1 are needed');
        }

        return new self((float) $margin, $format);
    }

    /** The margin in samples: the least whole number that is not below it. */
    public function marginSamples(int $pixelsPerDegree): int
    {
        return (int) ceil($this->marginDegrees * $pixelsPerDegree);
    }
}
