<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

/** A child process whose streams go to files, so that it never waits for its reader. */
final class ScriptRun
{
    public int $exitCode = -1;
    public string $output = '';
    public string $errors = '';

    /**
     * @param resource $process
     * @param array{resource, resource} $streams
     */
    private function __construct(private readonly mixed $process, private readonly array $streams)
    {
    }

    /**
     * @param list<string>          $command
     * @param array<string, string> $environment besides PATH and HOME
     */
    public static function start(array $command, array $environment = []): self
    {
        $streams = [tmpfile(), tmpfile()];
        $base = ['PATH' => (string) getenv('PATH'), 'HOME' => (string) getenv('HOME')];
        $process = proc_open($command, [['file', '/dev/null', 'r'], ...$streams], $pipes, null, [...$base, ...$environment]);

        return new self($process, $streams);
    }

    public function wait(): self
    {
        while (($status = proc_get_status($this->process))['running']) {
            usleep(2000);
        }
        $this->exitCode = $status['signaled'] ? 128 + $status['termsig'] : $status['exitcode'];
        // By name: the child has moved the place at which the streams would be read.
        [$this->output, $this->errors] = array_map(
            static fn (mixed $stream): string => (string) file_get_contents(stream_get_meta_data($stream)['uri']),
            $this->streams,
        );

        return $this;
    }

    public function isRunning(): bool
    {
        return proc_get_status($this->process)['running'];
    }

    /** Ends it at once, as kill -9 does. */
    public function kill(): void
    {
        proc_terminate($this->process, 9);
    }
}
