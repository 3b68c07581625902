<?php

declare(strict_types=1);

namespace Msisf\Scripts\Console;

/** How far a long work is, how fast it goes and how long it still takes: on a terminal one line that changes, else a line now and then. */
final class Progress
{
    private const TERMINAL_SECONDS = 0.2;

    private const LOG_SECONDS = 10.0;

    private readonly float $startedAt;

    private readonly bool $isTerminal;

    private float $toldAt;

    private int $done;

    /**
     * @param string $what plural of what is counted
     * @param int $alreadyDone not of this run: it counts for the percentage, not for the rate
     */
    public function __construct(
        private readonly Output $output,
        private readonly string $what,
        private readonly int $total,
        private readonly int $alreadyDone = 0,
    ) {
        $this->startedAt = $this->toldAt = hrtime(true) / 1e9;
        $this->isTerminal = stream_isatty($output->messageStream());
        $this->done = $alreadyDone;
    }

    public function reach(int $done): void
    {
        $this->done = $done;
        $now = hrtime(true) / 1e9;
        if ($now - $this->toldAt >= ($this->isTerminal ? self::TERMINAL_SECONDS : self::LOG_SECONDS)) {
            $this->toldAt = $now;
            $rate = ($done - $this->alreadyDone) / ($now - $this->startedAt);
            $left = $rate > 0.0 ? ', ' . self::duration(($this->total - $done) / $rate) . ' left' : '';
            $percent = intdiv(100 * $done, $this->total);
            $this->tell(sprintf('%d of %d %s (%d %%), %d/s%s', $done, $this->total, $this->what, $percent, (int) $rate, $left));
        }
    }

    public function finish(): void
    {
        $seconds = hrtime(true) / 1e9 - $this->startedAt;
        $count = $this->done - $this->alreadyDone;
        $this->tell(sprintf('%d %s in %s, %d/s', $count, $this->what, self::duration($seconds), (int) ($count / max($seconds, 1e-9))));
        if ($this->isTerminal) {
            fwrite($this->output->messageStream(), "\n");
        }
    }

    private function tell(string $text): void
    {
        if ($this->isTerminal) {
            fwrite($this->output->messageStream(), "\r$text\e[K");
        } else {
            $this->output->notice($text);
        }
    }

    private static function duration(float $seconds): string
    {
        return match (true) {
            $seconds < 10.0 => sprintf('%.1F s', $seconds),
            $seconds < 120.0 => sprintf('%d s', (int) $seconds),
            default => sprintf('%d min %d s', intdiv((int) $seconds, 60), (int) $seconds % 60),
        };
    }
}
