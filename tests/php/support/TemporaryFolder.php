<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

use FilesystemIterator;
use RecursiveDirectoryIterator;
use RecursiveIteratorIterator;

/** A folder of its own for one test; it goes with the object. */
final class TemporaryFolder
{
    private readonly string $root;

    public function __construct()
    {
        $this->root = sys_get_temp_dir() . '/msisf-test-' . bin2hex(random_bytes(8));
        mkdir($this->root, 0o700);
    }

    public function __destruct()
    {
        foreach ($this->content(RecursiveIteratorIterator::CHILD_FIRST) as $file) {
            $file->isDir() && !$file->isLink() ? rmdir($file->getPathname()) : unlink($file->getPathname());
        }
        rmdir($this->root);
    }

    public function path(string $name): string
    {
        return "$this->root/$name";
    }

    /** @return list<string> names of all files, sorted, relative to the folder */
    public function files(): array
    {
        $names = [];
        foreach ($this->content(RecursiveIteratorIterator::LEAVES_ONLY) as $file) {
            $names[] = substr($file->getPathname(), strlen($this->root) + 1);
        }
        sort($names);

        return $names;
    }

    private function content(int $mode): RecursiveIteratorIterator
    {
        return new RecursiveIteratorIterator(
            new RecursiveDirectoryIterator($this->root, FilesystemIterator::SKIP_DOTS),
            $mode,
        );
    }
}
