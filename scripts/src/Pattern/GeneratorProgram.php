<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Closure;
use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Console\Progress;
use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Exception\ExternalPartException;

/** What generate_pattern.php does: the work itself, or its distribution to processes. */
final class GeneratorProgram
{
    private readonly PatternRepository $repository;

    /** @var list<TileBatch> */
    private readonly array $batches;

    public function __construct(private readonly GeneratorOptions $options, private readonly Output $output)
    {
        $resolution = $options->resolution->value;
        $this->repository = new PatternRepository($options->repository, $resolution);
        $this->batches = TileBatch::cut($options->range->tiles(), $resolution, $options->pattern->marginSamples($resolution));
    }

    /**
     * The first process: makes the patterns, and prints their folder on stdout.
     *
     * @param list<string> $command the script and its arguments, for further processes
     */
    public function run(array $command): void
    {
        $start = hrtime(true);
        $this->options->connection->warn($this->output);
        $table = $this->openTable();
        $this->repository->makeFolder();
        $total = new GenerationReport();
        $display = new Progress($this->output, 'patterns', $this->tileCount());
        $progress = static function (GenerationReport $done) use (&$total, $display): void {
            $total = $total->plus($done);
            $display->reach($total->made + $total->kept);
        };
        $jobs = min($this->options->jobs, count($this->batches));
        if ($jobs === 1) {
            $this->makeShare($table, 1, 1, $progress);
        } else {
            unset($table); // it was opened to find what is wrong before there are several processes
            (new WorkerPool($command, $jobs))->wait($progress);
        }
        if ($total->made > 0) {
            $this->repository->removeStaleFiles();
        }
        $display->finish();
        $this->output->notice($total->summary((hrtime(true) - $start) / 1e9));
        $this->output->result($this->repository->folder());
    }

    /** A further process: makes its share, and reports each batch on stdout. */
    public function work(int $number, int $jobs): void
    {
        $this->makeShare($this->openTable(), $number, $jobs, static function (GenerationReport $done): void {
            if (@fwrite(STDOUT, $done->serialize() . "\n") === false) {
                throw new ExternalPartException('the first process is gone.');
            }
        });
    }

    private function tileCount(): int
    {
        return array_sum(array_map(static fn (TileBatch $batch): int => count($batch->layouts), $this->batches));
    }

    private function openTable(): ElevationTable
    {
        $connection = Connection::open($this->options->connection);
        $connection->useDatabase();

        return ElevationTable::open($connection, $this->options->resolution, $this->options->query);
    }

    /** @param Closure(GenerationReport): void $progress */
    private function makeShare(ElevationTable $table, int $number, int $jobs, Closure $progress): void
    {
        $generator = new PatternGenerator($table, $this->repository, $this->options->pattern->format, $this->options->makeAll);
        foreach ($this->batches as $index => $batch) {
            if ($index % $jobs === $number - 1) {
                $progress($generator->run($batch));
            }
        }
    }
}
