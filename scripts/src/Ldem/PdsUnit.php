<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

/** The units of labels, each in the spelling that stands for all others. */
final class PdsUnit
{
    public const DEGREE = 'deg';

    public const PIXELS_PER_DEGREE = 'pix/deg';

    public const PIXEL = 'pix';

    public const METRE = 'm';

    public const KILOMETRE = 'km';

    private const SPELLINGS = [
        'degree' => self::DEGREE, 'degrees' => self::DEGREE,
        'pixel' => self::PIXEL, 'pixels' => self::PIXEL, 'px' => self::PIXEL,
        'meter' => self::METRE, 'meters' => self::METRE, 'metre' => self::METRE, 'metres' => self::METRE,
        'kilometer' => self::KILOMETRE, 'kilometers' => self::KILOMETRE, 'kilometre' => self::KILOMETRE, 'kilometres' => self::KILOMETRE,
    ];

    /** A unit as labels write it, e.g. "PIXELS/DEGREE", in the spelling of the constants; an unknown one in small letters. */
    public static function of(string $text): string
    {
        $parts = array_map('trim', explode('/', strtolower($text)));

        return implode('/', array_map(static fn (string $part): string => self::SPELLINGS[$part] ?? $part, $parts));
    }
}
