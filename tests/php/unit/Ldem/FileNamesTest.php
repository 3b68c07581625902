<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Ldem;

use Msisf\Scripts\Ldem\FileNames;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

final class FileNamesTest extends TestCase
{
    private TemporaryFolder $folder;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
        mkdir($this->folder->path('LDEM_16.IMG'));
        touch($this->folder->path('ldem_4.img'));
        touch($this->folder->path('LDEM_64.img'));
        touch($this->folder->path('LDEM_64.IMG'));
    }

    /** @dataProvider names */
    public function testFindIgnoringCaseTakesTheVeryNameFirst(string $asked, ?string $found): void
    {
        self::assertSame($found === null ? null : $this->folder->path($found), FileNames::findIgnoringCase($this->folder->path($asked)));
    }

    public static function names(): array
    {
        return [
            'the name itself' => ['ldem_4.img', 'ldem_4.img'],
            'in capitals' => ['LDEM_4.IMG', 'ldem_4.img'],
            'both are there' => ['LDEM_64.img', 'LDEM_64.img'],
            'a folder' => ['ldem_16.img', null],
            'another name' => ['ldem_4.imgs', null],
            'another folder' => ['none/ldem_4.img', null],
        ];
    }
}
