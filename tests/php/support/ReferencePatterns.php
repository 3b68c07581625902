<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

use PHPUnit\Framework\Assert;

/** A repository that msis has written, to compare others with. */
final class ReferencePatterns
{
    private static ?self $ldem4 = null;

    private readonly TemporaryFolder $folder;

    /** @var array<string, string> hash of each pattern by file name */
    private readonly array $hashes;

    /**
     * @param string $label of the elevation model
     * @param list<string> $choice options that choose patterns; without them it has all
     */
    public function __construct(string $label, private readonly int $pixelsPerDegree, array $choice = [])
    {
        $this->folder = new TemporaryFolder();
        $run = ScriptRun::start([
            Parts::msis(), 'patterns', '--batch', '--res', (string) $pixelsPerDegree,
            '--ldem', $label, '--pattern-repos', $this->folder->path('msis'), ...$choice,
        ])->wait();
        Assert::assertSame(0, $run->exitCode, $run->errors);
        $this->hashes = $this->hashesIn($this->repository());
        if ($choice === []) {
            Assert::assertCount(2592, $this->hashes);
        }
    }

    /** The real LDEM_4; made once a run. */
    public static function ldem4(): self
    {
        return self::$ldem4 ??= new self((string) preg_replace('/IMG$/', 'LBL', Parts::ldem4Image()), 4);
    }

    public function repository(): string
    {
        return $this->folder->path('msis');
    }

    /**
     * Compares another repository with this one.
     *
     * @param bool $wantAll whether patterns that are not there are a difference
     *
     * @return list<string> names of patterns that differ or are foreign, and of missing ones
     */
    public function differencesIn(string $repository, bool $wantAll): array
    {
        $found = $this->hashesIn($repository);
        $different = array_keys(array_diff_assoc($found, $this->hashes));

        return $wantAll ? [...$different, ...array_keys(array_diff_key($this->hashes, $found))] : $different;
    }

    /** @return array<string, string> */
    private function hashesIn(string $repository): array
    {
        $hashes = [];
        foreach (array_map('basename', glob("$repository/$this->pixelsPerDegree/*")) as $name) {
            if (!str_ends_with($name, '.partial.inc')) {
                $hashes[$name] = hash_file('xxh128', "$repository/$this->pixelsPerDegree/$name");
            }
        }

        return $hashes;
    }
}
