<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

use RuntimeException;

/** A child process whose streams go to files, so that it never waits for its reader. */
final class ScriptRun
{
    /** Far above what any script here takes, even on a busy machine. */
    private const LIMIT_SECONDS = 600;

    public int $exitCode = -1;
    public string $output = '';
    public string $errors = '';

    /**
     * @param resource $process
     * @param array{resource, resource} $streams
     * @param int $deadline ns, by hrtime()
     */
    private function __construct(
        private readonly mixed $process,
        private readonly array $streams,
        private readonly string $command,
        private readonly int $deadline,
    ) {
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

        return new self($process, $streams, implode(' ', $command), hrtime(true) + self::LIMIT_SECONDS * 1_000_000_000);
    }

    public function wait(): self
    {
        while (($status = $this->status())['running']) {
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
        return $this->status()['running'];
    }

    /** Ends it at once, as kill -9 does. */
    public function kill(): void
    {
        proc_terminate($this->process, 9);
    }

    /** @return array<string, mixed> of proc_get_status(); a process that does not end fails the test that waits for it */
    private function status(): array
    {
        $status = proc_get_status($this->process);
        if ($status['running'] && hrtime(true) > $this->deadline) {
            $this->kill();
            throw new RuntimeException("$this->command did not end within " . self::LIMIT_SECONDS . ' s');
        }

        return $status;
    }
}
