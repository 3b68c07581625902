<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\IO;

use Msisf\Scripts\Exception\ExternalPartException;
use Msisf\Scripts\IO\AtomicFile;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

final class AtomicFileTest extends TestCase
{
    private TemporaryFolder $folder;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
    }

    public function testCommitReplacesTheFileInOneStep(): void
    {
        $path = $this->folder->path('a.inc');
        file_put_contents($path, 'old');
        $file = new AtomicFile($path);
        $file->put('length ___, rest');
        $file->putAt(7, '016');
        self::assertStringEqualsFile($path, 'old');

        $file->commit();

        self::assertStringEqualsFile($path, 'length 016, rest');
        self::assertSame(['a.inc'], $this->folder->files());
    }

    public function testTemporaryNameIsOfTheKindThatMsisCleansUp(): void
    {
        $file = new AtomicFile($this->folder->path('a.inc'));

        self::assertMatchesRegularExpression('/^a\.\d+-[0-9a-f]{32}\.partial\.inc$/', $this->folder->files()[0]);
        unset($file);
        self::assertSame([], $this->folder->files());
    }

    public function testConstructMissingFolderIsAClearError(): void
    {
        $this->expectException(ExternalPartException::class);
        $this->expectExceptionMessage('No such file or directory');
        new AtomicFile($this->folder->path('missing/a.inc'));
    }

    public function testCommitOverAFolderIsAClearErrorAndLeavesNothing(): void
    {
        mkdir($this->folder->path('a.inc'));
        touch($this->folder->path('a.inc/inside'));
        $file = new AtomicFile($this->folder->path('a.inc'));
        try {
            $file->commit();
            self::fail('The folder was replaced.');
        } catch (ExternalPartException $exception) {
            self::assertStringContainsString('a.inc: can\'t be written', $exception->getMessage());
        }
        self::assertSame(['a.inc/inside'], $this->folder->files());
    }
}
