<?php

declare(strict_types=1);

namespace Msisf\Scripts\Numerics;

/**
 * A number as the unevaluated sum of two doubles, about 106 bits. Only +, - and * of doubles are used, so that the C#
 * program gets the same bits (docs/pattern-format.md).
 *
 * M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
 * arithmetic", ACM TOMS 44 (2017), algorithms 6 and 11.
 */
final class DoubleDouble
{
    /** 2^27 + 1: cuts a double into two halves of 26 bits. */
    private const SPLITTER = 134217729.0;

    /**
     * @param float $high the sum, rounded to a double
     * @param float $low  what the rounding lost
     */
    public function __construct(public readonly float $high, public readonly float $low)
    {
    }

    /** The quotient of two whole numbers below 2^53. */
    public static function quotient(int $numerator, int $denominator): self
    {
        $high = (float) $numerator / (float) $denominator;
        $product = self::product($high, (float) $denominator);

        return new self($high, ($numerator - $product->high - $product->low) / $denominator);
    }

    /** Sum, within 3 units of the 106th bit. */
    public function plus(self $other): self
    {
        $high = self::sum($this->high, $other->high);
        $low = self::sum($this->low, $other->low);
        $sum = self::sumOfOrdered($high->high, $high->low + $low->high);

        return self::sumOfOrdered($sum->high, $low->low + $sum->low);
    }

    /** Product, within 5 units of the 106th bit. */
    public function times(self $other): self
    {
        $product = self::product($this->high, $other->high);
        $cross = ($this->high * $other->low) + ($this->low * $other->high);

        return self::sumOfOrdered($product->high, $product->low + $cross);
    }

    /** a + b exactly. */
    private static function sum(float $a, float $b): self
    {
        $sum = $a + $b;
        $bRounded = $sum - $a;
        $aRounded = $sum - $bRounded;

        return new self($sum, ($a - $aRounded) + ($b - $bRounded));
    }

    /** a + b exactly, for |a| >= |b|. */
    private static function sumOfOrdered(float $a, float $b): self
    {
        $sum = $a + $b;

        return new self($sum, $b - ($sum - $a));
    }

    /** a * b exactly (T. J. Dekker, Numer. Math. 18 (1971)). */
    private static function product(float $a, float $b): self
    {
        $scaled = self::SPLITTER * $a;
        $aHigh = $scaled - ($scaled - $a);
        $aLow = $a - $aHigh;
        $scaled = self::SPLITTER * $b;
        $bHigh = $scaled - ($scaled - $b);
        $bLow = $b - $bHigh;
        $product = $a * $b;

        return new self($product, (($aHigh * $bHigh - $product) + ($aHigh * $bLow) + ($aLow * $bHigh)) + ($aLow * $bLow));
    }
}
