<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Closure;
use Msisf\Scripts\Exception\ExternalPartException;

/** Runs the script several times over, each process with a share of the work. It needs no pcntl, which may be missing. */
final class WorkerPool
{
    /** @var list<WorkerProcess> */
    private array $workers = [];

    /**
     * @param list<string> $command the script and its arguments; each process gets its --worker besides
     * @throws ExternalPartException a process can't be started
     */
    public function __construct(array $command, int $jobs)
    {
        for ($number = 1; $number <= $jobs; $number++) {
            $this->workers[] = new WorkerProcess([PHP_BINARY, ...$command, "--worker=$number/$jobs"]);
        }
    }

    /** No process outlives the pool. */
    public function __destruct()
    {
        foreach ($this->workers as $worker) {
            $worker->end();
        }
    }

    /**
     * Waits for all processes, without a limit: a fine model takes hours. One that ends closes its pipes, which ends the wait
     * for it. The first failure ends them all, and is passed on.
     *
     * @param Closure(GenerationReport): void $progress is told of each batch
     */
    public function wait(Closure $progress): void
    {
        while (($streams = $this->streams()) !== []) {
            $none = null;
            // False: a signal came in between.
            if (@stream_select($streams, $none, $none, null) === false) {
                continue;
            }
            foreach ($this->workers as $worker) {
                foreach ($worker->read($streams) as $line) {
                    $progress(GenerationReport::deserialize($line));
                }
            }
        }
    }

    /** @return list<resource> what to wait for; nothing after the end of all */
    private function streams(): array
    {
        return array_merge(...array_map(static fn (WorkerProcess $worker): array => $worker->streams(), $this->workers));
    }
}
