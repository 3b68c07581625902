<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

/**
 * A text in memory with an address, for LOAD DATA LOCAL: the client library opens what the server names by PHP's streams.
 * The method names are those of PHP's stream wrappers.
 */
final class MemoryStream
{
    private const SCHEME = 'msisf-rows';

    private static string $text = '';

    /** @var resource|null set by PHP */
    public $context;

    private int $position = 0;

    public static function register(): void
    {
        if (!in_array(self::SCHEME, stream_get_wrappers(), true)) {
            stream_wrapper_register(self::SCHEME, self::class);
        }
    }

    /** @return string the address under which the text can be read until it is withdrawn */
    public static function offer(string $text): string
    {
        self::$text = $text;

        return self::SCHEME . '://rows';
    }

    public static function withdraw(): void
    {
        self::$text = '';
    }

    // phpcs:ignore PSR1.Methods.CamelCapsMethodName
    public function stream_open(string $path, string $mode): bool
    {
        return $mode[0] === 'r';
    }

    // phpcs:ignore PSR1.Methods.CamelCapsMethodName
    public function stream_read(int $count): string
    {
        $part = substr(self::$text, $this->position, $count);
        $this->position += strlen($part);

        return $part;
    }

    // phpcs:ignore PSR1.Methods.CamelCapsMethodName
    public function stream_eof(): bool
    {
        return $this->position >= strlen(self::$text);
    }

    /** @return array<string, int> */
    // phpcs:ignore PSR1.Methods.CamelCapsMethodName
    public function stream_stat(): array
    {
        return ['size' => strlen(self::$text)];
    }
}
