<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Ldem;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\Resolution;
use PHPUnit\Framework\TestCase;

final class ResolutionTest extends TestCase
{
    /** @dataProvider products */
    public function testOfProductHasItsTableAndSize(int $pixelsPerDegree, string $table, int $lines, int $samples): void
    {
        $resolution = Resolution::of($pixelsPerDegree);

        self::assertSame([$table, $lines, $samples], [$resolution->table(), $resolution->lines(), $resolution->lineSamples()]);
    }

    /** Sizes as NASA's labels have them (LINES and LINE_SAMPLES of the whole Moon). */
    public static function products(): array
    {
        return [
            [4, 'ldem_4', 720, 1440],
            [16, 'ldem_16', 2880, 5760],
            [64, 'ldem_64', 11520, 23040],
            [1024, 'ldem_1024', 184320, 368640],
        ];
    }

    /** @dataProvider others */
    public function testOfAnythingElseIsRefusedWithThePossibleOnes(int $pixelsPerDegree): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage("resolution $pixelsPerDegree px/deg: one of 4, 16, 32, 64, 128, 256, 512, 1024 is needed.");
        Resolution::of($pixelsPerDegree);
    }

    public static function others(): array
    {
        return [[0], [-4], [5], [8], [2048]];
    }
}
