<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\ExternalPartException;
use Msisf\Scripts\Exception\MsisfException;
use Msisf\Scripts\Exception\UsageException;
use RuntimeException;

/** One more process of the script, and the pipes on which it reports. */
final class WorkerProcess
{
    private const STDOUT = 1;
    private const STDERR = 2;

    /** s: from the end of its output to its own end. */
    private const END_SECONDS = 60;

    /** @var resource */
    private readonly mixed $process;

    /** @var array<int, resource> those that are open, by number */
    private array $pipes = [];

    /** @var array<int, string> what came and is not used yet */
    private array $texts = [self::STDOUT => '', self::STDERR => ''];

    private bool $hasEnded = false;

    /**
     * @param list<string> $command program and arguments
     * @throws ExternalPartException it can't be started
     */
    public function __construct(array $command)
    {
        $nothing = ['file', PHP_OS_FAMILY === 'Windows' ? 'NUL' : '/dev/null', 'r'];
        $process = @proc_open($command, [$nothing, ['pipe', 'w'], ['pipe', 'w']], $this->pipes);
        if ($process === false) {
            throw new ExternalPartException("$command[0]: can't be started as a further process. Run with --jobs 1.");
        }
        $this->process = $process;
        foreach ($this->pipes as $pipe) {
            stream_set_blocking($pipe, false);
        }
    }

    /** @return array<int, resource> what to wait for; nothing after the end */
    public function streams(): array
    {
        return array_values($this->pipes);
    }

    /**
     * Takes what has come.
     *
     * @param list<resource> $ready streams that have something
     *
     * @return list<string> whole lines of stdout
     * @throws MsisfException|RuntimeException the process has failed, with its message
     */
    public function read(array $ready): array
    {
        foreach ($this->pipes as $number => $pipe) {
            if (in_array($pipe, $ready, true)) {
                $this->texts[$number] .= (string) stream_get_contents($pipe);
                if (feof($pipe)) {
                    unset($this->pipes[$number]);
                    fclose($pipe);
                }
            }
        }
        if ($this->pipes === [] && !$this->hasEnded) {
            $this->hasEnded = true;
            $this->requireSuccess();
        }
        $lines = explode("\n", $this->texts[self::STDOUT]);
        $this->texts[self::STDOUT] = (string) array_pop($lines);

        return $lines;
    }

    /** Ends the process if it runs. */
    public function end(): void
    {
        if ($this->pipes !== []) {
            proc_terminate($this->process);
            array_map(fclose(...), $this->pipes);
            $this->pipes = [];
        }
    }

    private function requireSuccess(): void
    {
        // Its pipes are closed, so it is about to end.
        $deadline = hrtime(true) + self::END_SECONDS * 1_000_000_000;
        while (($status = proc_get_status($this->process))['running']) {
            if (hrtime(true) > $deadline) {
                proc_terminate($this->process, 9);
                throw new ExternalPartException('one of the processes has closed its output and does not end. Run this again: patterns that are there are kept.');
            }
            usleep(1000);
        }
        $text = trim($this->texts[self::STDERR]);
        $message = (string) preg_replace('/^\S+: error: /', '', $text);
        if ($status['signaled']) {
            throw new ExternalPartException(
                "one of the processes was ended by signal {$status['termsig']}. Run this again: patterns that are there are kept.",
            );
        }
        match ($status['exitcode']) {
            0 => null,
            1 => throw new UsageException($message),
            2 => throw new BadInputException($message),
            3 => throw new ExternalPartException($message),
            default => throw new RuntimeException("a process ended with exit code {$status['exitcode']}: $text"),
        };
    }
}
