<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

/** A piece of a PDS3 label. */
final class PdsToken
{
    /**
     * @param string $text without quotes or brackets
     * @param int $line line of its first character, from 1
     */
    public function __construct(
        public readonly PdsTokenKind $kind,
        public readonly string $text,
        public readonly int $line,
    ) {
    }

    public function isSign(string $sign): bool
    {
        return $this->kind === PdsTokenKind::Sign && $this->text === $sign;
    }
}
