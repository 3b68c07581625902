<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Exception\BadInputException;
use PDO;

/** Encryption of the connection, from the options ssl-mode, ssl-ca and ssl-verify-server-cert; msis follows the same rules. */
final class TlsSettings
{
    /** PDO can't check a certificate without the host's name, so VERIFY_CA is for neither program. */
    private const MODES = [
        'DISABLED' => TlsMode::Disabled,
        'REQUIRED' => TlsMode::Required,
        'VERIFY_IDENTITY' => TlsMode::VerifyIdentity,
    ];

    /** @param string|null $certificateAuthority PEM file of the trusted authority; null for those of the system */
    private function __construct(public readonly TlsMode $mode, public readonly ?string $certificateAuthority)
    {
    }

    /**
     * What the options ask for; a named authority asks to verify the server.
     *
     * @param string|null $verify an empty text switches it on, as the name alone does in an option file
     * @throws BadInputException a value is wrong, or one option asks to verify the server and another one not to
     */
    public static function of(?string $modeName, ?string $authority, ?string $verify): self
    {
        $mode = $modeName === null ? null : self::mode($modeName);
        $verifies = $verify === null ? null : self::isOn($verify);
        if ($authority !== null && !is_file($authority)) {
            throw new BadInputException("ssl-ca $authority: this file is missing. It holds the certificate of the authority, as PEM.");
        }
        $asks = $mode === TlsMode::VerifyIdentity || $verifies === true || $authority !== null;
        $declines = $mode === TlsMode::Disabled || $mode === TlsMode::Required || $verifies === false;
        if ($asks && $declines) {
            throw new BadInputException('ssl-mode, ssl-ca and ssl-verify-server-cert contradict each other: one asks to verify the server, '
                . 'another one not to. Leave one of them out.');
        }
        $chosen = $asks ? TlsMode::VerifyIdentity : $mode ?? ($declines ? TlsMode::Required : TlsMode::Default);

        return new self($chosen, $authority);
    }

    /**
     * For the constructor of PDO. It encrypts only if an authority or a list of ciphers is named, and says nothing if it does not.
     *
     * @return array<int, bool|string>
     */
    public function pdoOptions(): array
    {
        return match ($this->mode) {
            TlsMode::Default, TlsMode::Disabled => [],
            TlsMode::Required => [PDO::MYSQL_ATTR_SSL_CIPHER => 'DEFAULT', PDO::MYSQL_ATTR_SSL_VERIFY_SERVER_CERT => false],
            TlsMode::VerifyIdentity => [PDO::MYSQL_ATTR_SSL_VERIFY_SERVER_CERT => true] + ($this->certificateAuthority === null
                ? [PDO::MYSQL_ATTR_SSL_CIPHER => 'DEFAULT']
                : [PDO::MYSQL_ATTR_SSL_CA => $this->certificateAuthority]),
        };
    }

    private static function mode(string $name): TlsMode
    {
        return self::MODES[strtoupper($name)]
            ?? throw new BadInputException("ssl-mode '$name': one of " . implode(', ', array_keys(self::MODES)) . ' is needed.');
    }

    private static function isOn(string $text): bool
    {
        return match (strtoupper($text)) {
            '', '1', 'ON', 'TRUE' => true,
            '0', 'OFF', 'FALSE' => false,
            default => throw new BadInputException("ssl-verify-server-cert '$text': 1 or 0 is needed."),
        };
    }
}
