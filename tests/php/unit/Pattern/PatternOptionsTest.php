<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Exception\UsageException;
use Msisf\Scripts\Pattern\PatternFormat;
use Msisf\Scripts\Pattern\PatternOptions;
use PHPUnit\Framework\TestCase;

final class PatternOptionsTest extends TestCase
{
    /** @dataProvider margins */
    public function testMarginSamplesAreNotLessThanTheMargin(string $margin, int $pixelsPerDegree, int $expected): void
    {
        self::assertSame($expected, PatternOptions::parse($margin, PatternFormat::Mesh2)->marginSamples($pixelsPerDegree));
    }

    public static function margins(): array
    {
        return [
            'none' => ['0', 64, 0],
            'the thesis at 4 px/deg' => ['0.5', 4, 2],
            'the thesis at 64 px/deg: 6.4' => ['0.1', 64, 7],
            'the smallest' => ['.0001', 4, 1],
            'the largest' => ['+1.', 16, 16],
        ];
    }

    /** @dataProvider wrongMargins */
    public function testParseWrongMarginIsRefused(string $margin): void
    {
        $this->expectException(UsageException::class);
        $this->expectExceptionMessage('degrees from 0 (tiles meet without one) to 1 are needed');
        PatternOptions::parse($margin, PatternFormat::Mesh2);
    }

    public static function wrongMargins(): array
    {
        return [['1.01'], ['-0.1'], ['1e-1'], [''], ['.'], ['NAN'], ["0.5\n"], ['0,5']];
    }
}
