<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

/** What was done so far, and where the time went; those of several processes can be added. */
final class GenerationReport
{
    public function __construct(
        public readonly int $made = 0,
        public readonly int $kept = 0,
        public readonly float $databaseSeconds = 0.0,
        public readonly float $computingSeconds = 0.0,
        public readonly float $writingSeconds = 0.0,
    ) {
    }

    public function plus(self $other): self
    {
        return new self(
            $this->made + $other->made,
            $this->kept + $other->kept,
            $this->databaseSeconds + $other->databaseSeconds,
            $this->computingSeconds + $other->computingSeconds,
            $this->writingSeconds + $other->writingSeconds,
        );
    }

    /** One line for another process. */
    public function serialize(): string
    {
        return json_encode(get_object_vars($this), JSON_THROW_ON_ERROR);
    }

    public static function deserialize(string $line): self
    {
        return new self(...json_decode($line, true, 2, JSON_THROW_ON_ERROR));
    }

    /** @param float $seconds that went by, also where several processes shared the work */
    public function summary(float $seconds): string
    {
        $work = max($this->databaseSeconds + $this->computingSeconds + $this->writingSeconds, 1e-9);

        return sprintf(
            '%d patterns made, %d were there, in %.1F s: database %.1F s (%.0F %%), PHP %.1F s (%.0F %%), writing %.1F s (%.0F %%).',
            $this->made,
            $this->kept,
            $seconds,
            $this->databaseSeconds,
            100 * $this->databaseSeconds / $work,
            $this->computingSeconds,
            100 * $this->computingSeconds / $work,
            $this->writingSeconds,
            100 * $this->writingSeconds / $work,
        );
    }
}
