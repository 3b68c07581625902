<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use JsonException;
use Msisf\Scripts\Pattern\GenerationReport;
use PHPUnit\Framework\TestCase;

final class GenerationReportTest extends TestCase
{
    public function testPlusAddsEachPart(): void
    {
        self::assertEquals(
            new GenerationReport(11, 22, 1.5, 0.75, 3.125),
            (new GenerationReport(1, 2, 1.0, 0.5, 3.0))->plus(new GenerationReport(10, 20, 0.5, 0.25, 0.125)),
        );
    }

    public function testSerializeIsOneLineThatReadsBackTheSame(): void
    {
        $line = (new GenerationReport(3, 4, 0.1, 0.25, 1e-7))->serialize();

        self::assertSame('{"made":3,"kept":4,"databaseSeconds":0.1,"computingSeconds":0.25,"writingSeconds":1.0e-7}', $line);
        self::assertEquals(new GenerationReport(3, 4, 0.1, 0.25, 1e-7), GenerationReport::deserialize($line));
    }

    public function testDeserializeCutLineIsRefused(): void
    {
        $this->expectException(JsonException::class);
        GenerationReport::deserialize('{"made":3,"kept');
    }

    public function testSummarySharesAreOfTheWorkNotOfTheTimeThatWentBy(): void
    {
        self::assertSame(
            '7 patterns made, 2 were there, in 3.0 s: database 4.0 s (50 %), PHP 3.0 s (38 %), writing 1.0 s (12 %).',
            (new GenerationReport(7, 2, 4.0, 3.0, 1.0))->summary(3.0),
        );
        self::assertStringContainsString('database 0.0 s (0 %)', (new GenerationReport())->summary(0.0));
    }
}
