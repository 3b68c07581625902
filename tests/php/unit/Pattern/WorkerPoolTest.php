<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\ExternalPartException;
use Msisf\Scripts\Pattern\GenerationReport;
use Msisf\Scripts\Pattern\WorkerPool;
use PHPUnit\Framework\TestCase;

final class WorkerPoolTest extends TestCase
{
    private const REPORT = 'echo json_encode(["made" => 2, "kept" => 1, "databaseSeconds" => 0.5, '
        . '"computingSeconds" => 0.25, "writingSeconds" => 0.125]), "\n"; ';

    public function testWaitAddsTheReportsOfAllProcesses(): void
    {
        $total = self::runTwo(self::REPORT . self::REPORT);

        self::assertEquals(new GenerationReport(8, 4, 2.0, 1.0, 0.5), $total);
    }

    public function testWaitProcessThatFailsPassesItsMessageAndKindOn(): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessageMatches('/^table ldem_4: gone\.$/');
        self::runTwo('if ($argv[1] === "--worker=2/2") { fwrite(STDERR, "x.php: error: table ldem_4: gone.\n"); exit(2); } sleep(60);');
    }

    public function testWaitProcessThatIsKilledIsNamed(): void
    {
        $this->expectException(ExternalPartException::class);
        $this->expectExceptionMessage('signal 9');
        self::runTwo(self::REPORT . 'posix_kill(getmypid(), 9);');
    }

    private static function runTwo(string $code): GenerationReport
    {
        $total = new GenerationReport();
        (new WorkerPool(['-r', $code, '--'], 2))->wait(static function (GenerationReport $done) use (&$total): void {
            $total = $total->plus($done);
        });

        return $total;
    }
}
