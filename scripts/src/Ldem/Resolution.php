<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

use Msisf\Scripts\Exception\BadInputException;

/** The resolutions of the LDEM products, in px/deg: the only ones for which there are tables. */
enum Resolution: int
{
    case Px4 = 4;
    case Px16 = 16;
    case Px32 = 32;
    case Px64 = 64;
    case Px128 = 128;
    case Px256 = 256;
    case Px512 = 512;
    case Px1024 = 1024;

    /** @throws BadInputException there are no products of this resolution */
    public static function of(int $pixelsPerDegree): self
    {
        return self::tryFrom($pixelsPerDegree) ?? throw new BadInputException(
            "resolution $pixelsPerDegree px/deg: one of " . implode(', ', array_column(self::cases(), 'value')) . ' is needed.'
        );
    }

    /** Name of the table; made of nothing that a user writes. */
    public function table(): string
    {
        return "ldem_$this->value";
    }

    /** Lines of the whole Moon. */
    public function lines(): int
    {
        return 180 * $this->value;
    }

    /** Samples of a whole line. */
    public function lineSamples(): int
    {
        return 360 * $this->value;
    }
}
