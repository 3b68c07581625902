<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

/** The spellings of units that labels use; the first is NASA's in LDEM labels. */
final class PdsUnits
{
    public const DEGREES = ['deg', 'degree', 'degrees'];

    public const PIXELS_PER_DEGREE = ['pix/deg', 'pixel/deg', 'pixel/degree', 'pixels/degree'];

    public const PIXELS = ['pix', 'pixel', 'pixels'];

    public const KILOMETRES = ['km', 'kilometer', 'kilometers'];
}
