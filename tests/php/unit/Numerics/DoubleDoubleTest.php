<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Numerics;

use Msisf\Scripts\Numerics\DoubleDouble;
use PHPUnit\Framework\TestCase;

/** Expected bits: mpmath with 300 bits, rounded to a double, and the rest rounded to a double. */
final class DoubleDoubleTest extends TestCase
{
    private const PI = ['400921fb54442d18', '3ca1a62633145c07'];

    private const E = ['4005bf0a8b145769', '3ca4d57ee2b1013a'];

    /** @dataProvider quotients */
    public function testQuotientHasTheBitsThatADoubleLoses(int $numerator, int $denominator, array $expected): void
    {
        self::assertSame($expected, self::bits(DoubleDouble::quotient($numerator, $denominator)));
    }

    public static function quotients(): array
    {
        return [
            [1, 3, ['3fd5555555555555', '3c75555555555555']],
            [2, 7, ['3fd2492492492492', '3c72492492492492']],
            'exact' => [-3, 4, ['bfe8000000000000', '0000000000000000']],
        ];
    }

    public function testPlusAndTimesOfPiAndE(): void
    {
        $pi = self::number(self::PI);
        $e = self::number(self::E);

        self::assertRest(['40177082efac4241', -1.7705984076240228e-16], $pi->plus($e));
        self::assertRest(['402114580b45d475', -6.773815290502424e-16], $pi->times($e));
        self::assertRest(['3fdb1786497ead78', -2.2100009258189695e-17], $pi->plus($e->times(new DoubleDouble(-1.0, 0.0))));
    }

    public function testPlusKeepsWhatCancellationLeaves(): void
    {
        $small = 2.0 ** -90;

        $left = (new DoubleDouble(1.0, $small))->plus(new DoubleDouble(-1.0, 0.0));

        self::assertSame([$small, 0.0], [$left->high, $left->low]);
    }

    public function testTimesSquareIsExactWhereItHasRoom(): void
    {
        // (1 + 2^-40)^2 = 1 + 2^-39 + 2^-80
        $number = new DoubleDouble(1.0 + 2.0 ** -40, 0.0);

        $square = $number->times($number);

        self::assertSame([1.0 + 2.0 ** -39, 2.0 ** -80], [$square->high, $square->low]);
    }

    /** The low part within 5 units of the 106th bit, as the class promises. */
    private static function assertRest(array $expected, DoubleDouble $found): void
    {
        self::assertSame($expected[0], self::bits($found)[0]);
        self::assertEqualsWithDelta($expected[1], $found->low, 5 * abs($found->high) * 2.0 ** -106);
    }

    private static function number(array $bits): DoubleDouble
    {
        return new DoubleDouble(unpack('E', hex2bin($bits[0]))[1], unpack('E', hex2bin($bits[1]))[1]);
    }

    /** @return array{string, string} */
    private static function bits(DoubleDouble $number): array
    {
        return [bin2hex(pack('E', $number->high)), bin2hex(pack('E', $number->low))];
    }
}
