<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Generator;
use Msisf\Scripts\IO\AtomicFile;

/** Writes a tile's mesh as a pattern file for POV-Ray: the same mesh always gives the same bytes (docs/pattern-format.md). */
final class PatternWriter
{
    /** Bytes to collect before they are written: PHP hands each write to the system as it is. */
    private const CHUNK_BYTES = 1 << 20;

    private readonly FaceText $faces;

    public function __construct(private readonly PatternFormat $format)
    {
        $this->faces = new FaceText();
    }

    /**
     * Writes a pattern into a new file.
     *
     * @param string $header the header without length
     */
    public function write(AtomicFile $file, TileMesh $mesh, string $header): void
    {
        $written = 0;
        $chunk = $header . PatternHeader::length(0) . "\n";
        $pieces = $this->format === PatternFormat::Mesh2 ? $this->mesh2($mesh) : TriangleText::of($mesh);
        foreach ($pieces as $piece) {
            $chunk .= $piece;
            if (strlen($chunk) >= self::CHUNK_BYTES) {
                $file->put($chunk);
                $written += strlen($chunk);
                $chunk = '';
            }
        }
        $file->put($chunk);
        $file->putAt(strlen($header), PatternHeader::length($written + strlen($chunk)));
    }

    /**
     * Whole steps times the local k = 2^-17: exact as 32-bit floats, and of the size of kilometres.
     *
     * @return Generator<int, string>
     */
    private function mesh2(TileMesh $mesh): Generator
    {
        yield "#local k=1/131072;\nmesh2{\nvertex_vectors{{$mesh->layout->vertexCount()}";
        foreach ($mesh->vertexLines(">*k,\n<") as $line) {
            yield ",\n<$line>*k";
        }
        yield "}\nface_indices{{$mesh->layout->faceCount()}";
        yield from $this->faces->of($mesh->layout);
        yield "}\ntranslate <" . implode(',', $mesh->origin) . ">*k\nscale 1.024\ntexture{moon}\n}\n";
    }
}
