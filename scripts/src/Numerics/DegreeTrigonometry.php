<?php

declare(strict_types=1);

namespace Msisf\Scripts\Numerics;

use InvalidArgumentException;

/**
 * Sine and cosine of a whole number of parts of a degree, rounded to the nearest double and the same on every machine
 * and in every language with IEEE doubles: sin() may differ in the last bit between C libraries.
 *
 * The symmetries hold bit for bit: sin(180 - a) = sin a, cos(90 - a) = sin a, sin(-a) = -sin a; and sin 0 = 0,
 * sin 30 = 0.5, sin 90 = 1. Zero is never negative. The algorithm is written down in docs/pattern-format.md, the C#
 * program has it in src/Msisf.Core/Numerics/DegreeTrigonometry.cs.
 */
final class DegreeTrigonometry
{
    private const RADIANS_PER_DEGREE = [0.017453292519943295, 2.9486522708701687e-19];

    /** (-1)^k / (2k + 1)!: sin x = x * sum of coefficient k times x^(2k). The next term is below 2^-112 up to 45 degrees. */
    private const SINE_SERIES = [
        [1.0, 0.0],
        [-0.16666666666666666, -9.25185853854297e-18],
        [0.008333333333333333, 1.1564823173178714e-19],
        [-0.0001984126984126984, -1.7209558293420705e-22],
        [2.7557319223985893e-06, -1.858393274046472e-22],
        [-2.505210838544172e-08, 1.448814070935912e-24],
        [1.6059043836821613e-10, 1.2585294588752098e-26],
        [-7.647163731819816e-13, -7.03872877733453e-30],
        [2.8114572543455206e-15, 1.6508842730861433e-31],
        [-8.22063524662433e-18, -2.2141894119604265e-34],
        [1.9572941063391263e-20, -1.3643503830087908e-36],
        [-3.868170170630684e-23, 8.843177655482344e-40],
        [6.446950284384474e-26, -1.9330404233703465e-42],
        [-9.183689863795546e-29, -1.4303150396787322e-45],
    ];

    /** (-1)^k / (2k)!: cos x = sum of coefficient k times x^(2k). */
    private const COSINE_SERIES = [
        [1.0, 0.0],
        [-0.5, 0.0],
        [0.041666666666666664, 2.3129646346357427e-18],
        [-0.001388888888888889, 5.300543954373577e-20],
        [2.48015873015873e-05, 2.1511947866775882e-23],
        [-2.755731922398589e-07, -2.3767714622250297e-23],
        [2.08767569878681e-09, -1.20734505911326e-25],
        [-1.1470745597729725e-11, -2.0655512752830745e-28],
        [4.779477332387385e-14, 4.399205485834081e-31],
        [-1.5619206968586225e-16, -1.1910679660273754e-32],
        [4.110317623312165e-19, 1.4412973378659527e-36],
        [-8.896791392450574e-22, 7.911402614872376e-38],
        [1.6117375710961184e-24, -3.6846573564509766e-41],
        [-2.4795962632247976e-27, 1.2953730964765229e-43],
        [3.279889237069838e-30, 1.5117542744029879e-46],
    ];

    /**
     * Sine of numerator / denominator degrees.
     *
     * @param int $denominator parts of a degree, 1 to 2^40
     */
    public static function sin(int $numerator, int $denominator): float
    {
        if ($denominator < 1 || $denominator > 1 << 40) {
            throw new InvalidArgumentException("$denominator parts of a degree; 1 to 2^40 are possible.");
        }
        $quarter = 90 * $denominator;
        $angle = $numerator % (4 * $quarter);
        if ($angle < 0) {
            $angle += 4 * $quarter;
        }
        $rest = $angle % $quarter;

        return match (intdiv($angle, $quarter)) {
            0 => self::firstQuarterSine($rest, $denominator),
            1 => self::firstQuarterSine($quarter - $rest, $denominator),
            2 => 0.0 - self::firstQuarterSine($rest, $denominator),
            default => 0.0 - self::firstQuarterSine($quarter - $rest, $denominator),
        };
    }

    /**
     * Cosine of numerator / denominator degrees.
     *
     * @param int $numerator   any whole number that leaves room for 90 degrees more
     * @param int $denominator parts of a degree, 1 to 2^40
     */
    public static function cos(int $numerator, int $denominator): float
    {
        return self::sin($numerator + (90 * $denominator), $denominator);
    }

    private static function firstQuarterSine(int $angle, int $denominator): float
    {
        if ($angle > 45 * $denominator) {
            return self::sum(self::COSINE_SERIES, self::radians((90 * $denominator) - $angle, $denominator))->high;
        }
        $radians = self::radians($angle, $denominator);

        return $radians->times(self::sum(self::SINE_SERIES, $radians))->high;
    }

    private static function radians(int $angle, int $denominator): DoubleDouble
    {
        return DoubleDouble::quotient($angle, $denominator)->times(new DoubleDouble(...self::RADIANS_PER_DEGREE));
    }

    /** @param list<array{float, float}> $series */
    private static function sum(array $series, DoubleDouble $x): DoubleDouble
    {
        $square = $x->times($x);
        $sum = new DoubleDouble(0.0, 0.0);
        foreach (array_reverse($series) as $coefficient) {
            $sum = $sum->times($square)->plus(new DoubleDouble(...$coefficient));
        }

        return $sum;
    }
}
