<?php

declare(strict_types=1);

namespace Msisf\Scripts\Console;

/** Results go to stdout; progress, notices and errors to stderr. */
final class Output
{
    /**
     * @param resource $results
     * @param resource $messages
     */
    public function __construct(
        private readonly string $scriptName,
        private readonly mixed $results,
        private readonly mixed $messages,
    ) {
    }

    public static function ofProcess(string $scriptName): self
    {
        return new self($scriptName, STDOUT, STDERR);
    }

    public function result(string $line): void
    {
        fwrite($this->results, $line . "\n");
    }

    public function notice(string $line): void
    {
        fwrite($this->messages, "$this->scriptName: $line\n");
    }

    public function error(string $line): void
    {
        $this->notice("error: $line");
    }

    /** Many lines as they are: a stack trace. */
    public function detail(string $text): void
    {
        fwrite($this->messages, $text . "\n");
    }

    /** @return resource for what draws on the terminal itself */
    public function messageStream(): mixed
    {
        return $this->messages;
    }
}
