<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Tests\Support\LabelText;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\PrivateServer;
use Msisf\Tests\Support\ScriptRun;
use Msisf\Tests\Support\TestLength;
use PDO;
use Random\Engine\Mt19937;
use Random\Randomizer;

/** Whatever stops an import, the same command again completes it: nothing is lost, nothing is there twice. */
final class InterruptedImportTest extends ImportTestCase
{
    private const KILLS = 4;

    /** So many with MSISF_LONG_TESTS=1. */
    private const MOST_KILLS = 20;

    /** Microseconds: a kill comes within so much time after the start, later where that was too early. */
    private const SPAN = 400_000;

    /** Of the real model: the product below. */
    private const NORTHERN = 'row_index < 120 AND col_index < 480';

    /** The bar is there as long as its connection is: dropped at once by PHP if nobody keeps it. */
    private ?PDO $bar = null;

    protected function tearDown(): void
    {
        $this->bar = null;
    }

    public function testImportKilledManyTimesEndsAsIfUndisturbed(): void
    {
        $random = new Randomizer(new Mt19937(20120222));
        $label = $this->northernProduct();
        $undisturbed = $this->checksum(self::NORTHERN, ImportedModels::ldem4());
        $this->barTheSecondTransaction();
        $run = $this->startedUntilTheBar($label);
        $run->kill();
        $run->wait();
        $this->bar->rollBack();
        self::assertSame(40, $this->rowsDone(), 'The first kill did not come in the middle.');
        $span = self::SPAN;
        for ($kill = 0; $kill < TestLength::of(self::KILLS, self::MOST_KILLS); $kill++) {
            $before = $this->rowsDone();
            // Others see a commit shortly before it is on the disk.
            $this->execute('FLUSH ENGINE LOGS');
            $run = $this->start([$label]);
            usleep($random->getInt(20_000, $span));
            if ($kill % 2 === 0) {
                $run->kill();
                $run->wait();
            } else {
                PrivateServer::shared()->kill();
                $run->wait();
                PrivateServer::shared()->restart();
                self::assertContains($run->exitCode, [0, 3], $run->errors);
            }
            $after = $this->rowsDone();
            self::assertGreaterThanOrEqual($before, $after, 'A kill took back what was done.');
            // Kills that all come too early, or too late, would test one place only, whatever the speed of the machine.
            $span = $after === $before ? (int) (1.3 * $span) : self::SPAN;
            if ($after === 120) {
                $this->execute('DROP TABLE ldem_4, ldem_import');
            }
        }
        self::assertDone($this->import([$label]));
        self::assertSame($undisturbed, $this->checksum(self::NORTHERN));
        self::assertDone($this->import(['--verify', $label]));
    }

    public function testImportServerGoneSaysSoAndGoesOnLater(): void
    {
        $label = $this->northernProduct();
        $this->barTheSecondTransaction();
        $run = $this->startedUntilTheBar($label);
        // Others see a commit shortly before it is on the disk; at the bar it is there.
        $this->waitingInsert($run);
        PrivateServer::shared()->kill();
        $run->wait();
        PrivateServer::shared()->restart();
        self::assertRefused(3, 'has gone away', $run);
        self::assertStringContainsString('run this again', $run->errors);
        $again = $this->import([$label]);
        self::assertDone($again);
        self::assertMatchesRegularExpression('/going on after line 40\n/', $again->errors);
        self::assertSame($this->checksum(self::NORTHERN, ImportedModels::ldem4()), $this->checksum(self::NORTHERN));
    }

    public function testImportConnectionKilledByTheAdministratorLosesNothing(): void
    {
        $label = $this->northernProduct();
        $this->barTheSecondTransaction();
        $run = $this->startedUntilTheBar($label);
        $this->execute('KILL ' . $this->waitingInsert($run));
        self::assertRefused(3, 'run this again', $run->wait());
        $this->bar->rollBack();
        self::assertDone($this->import([$label]));
        self::assertDone($this->import(['--verify', $label]));
    }

    public function testImportTwoAtOnceTheSecondWaitsAndFindsItDone(): void
    {
        $label = $this->northernProduct();
        $this->barTheSecondTransaction();
        $first = $this->startedUntilTheBar($label);
        self::assertRefused(3, 'another import into ldem_4', $this->import(['--wait=0', $label]));
        $second = $this->start([$label]);
        while (!$this->isWaiting() && $second->isRunning()) {
            usleep(5000);
        }
        $this->bar->rollBack();
        self::assertDone($first->wait());
        self::assertDone($second->wait());
        self::assertStringContainsString('waiting up to 600 s', $second->errors);
        self::assertStringContainsString('is in ldem_4 already', $second->errors);
        self::assertSame($first->output, $second->output);
        self::assertSame(57600, $this->value('SELECT COUNT(*) FROM ldem_4 WHERE ' . self::NORTHERN));
    }

    public function testImportDiskFullSaysSoAndGoesOnLater(): void
    {
        $folder = $this->value('SELECT @@datadir') . $this->environment['MSISF_DB_DATABASE'];
        exec('mount -t tmpfs -o size=6m,mode=777 none ' . escapeshellarg($folder) . ' 2>&1', $lines, $code);
        if ($code !== 0) {
            self::assertNotSame('true', getenv('CI') ?: '', 'missing: the right to mount a small disk');
            self::markTestSkipped('missing: the right to mount a small disk');
        }
        try {
            $label = $this->northernProduct();
            $run = $this->import([$label]);
            self::assertRefused(3, 'is full', $run);
            self::assertStringContainsString('Make room and run this again: it goes on where it stopped.', $run->errors);
            exec('mount -o remount,size=512m ' . escapeshellarg($folder));
            self::assertDone($this->import([$label]));
            self::assertSame($this->checksum(self::NORTHERN, ImportedModels::ldem4()), $this->checksum());
            $this->execute('DROP TABLE ldem_4, ldem_import');
        } finally {
            exec('umount -l ' . escapeshellarg($folder));
        }
    }

    /** A third of the north of the real model as a product of its own: three transactions. */
    private function northernProduct(): string
    {
        $lines = str_split((string) file_get_contents(Parts::ldem4Image(), length: 120 * 2880), 2880);
        $samples = implode('', array_map(static fn (string $line): string => substr($line, 0, 960), $lines));

        return LabelText::writeProduct($this->folder, 'LDEM_4_60N_90N_000_120', [90, 60, 0, 120], $samples);
    }

    /** Puts a row of the northern product's lines 41 to 80 into a transaction left open: an import waits there. */
    private function barTheSecondTransaction(): void
    {
        self::assertDone($this->import([$this->smallProduct()]));

        $this->bar = PrivateServer::shared()->hold(
            $this->environment,
            "INSERT INTO ldem_4 VALUES (60, 0, 0, 0, 0, 0, 0, 0, ST_GeomFromText('POINT(0 0)', 0))",
        );
    }

    /** The import of the northern product, once it waits at the bar. */
    private function startedUntilTheBar(string $label): ScriptRun
    {
        $run = $this->start([$label]);
        while ($this->rowsDone() < 40 && $run->isRunning()) {
            usleep(5000);
        }

        return $run;
    }

    /** The connection whose INSERT waits at the bar: others of earlier imports may still be ending. */
    private function waitingInsert(ScriptRun $run): int
    {
        $database = $this->environment['MSISF_DB_DATABASE'];
        do {
            usleep(5000);
            $id = $this->value(
                "SELECT MAX(id) FROM information_schema.processlist WHERE db = '$database' AND info LIKE 'INSERT INTO ldem_4%'",
            );
        } while ($id === null && $run->isRunning());
        self::assertNotNull($id, "The import ended before it waited: $run->errors");

        return (int) $id;
    }

    /** Whether a connection waits for the name of the import that another one holds. */
    private function isWaiting(): bool
    {
        return $this->value("SELECT COUNT(*) FROM information_schema.processlist WHERE state = 'User lock'") > 0;
    }

    private function rowsDone(): int
    {
        $exists = $this->value("SELECT COUNT(*) FROM information_schema.tables WHERE table_schema = DATABASE() AND table_name = 'ldem_import'");

        return $exists === 0 ? 0 : (int) $this->value('SELECT COALESCE(MAX(rows_done), 0) FROM ldem_import WHERE product_id <> \'SMALL\'');
    }
}
