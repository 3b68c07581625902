<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

/** A bulk way to bring radii to the server: into the connection's temporary table GridTables::RADII, empty before. */
interface RadiusLoader
{
    /** Name for messages. */
    public function name(): string;

    /**
     * @param list<string> $rows "row TAB column TAB radius", radii in m
     */
    public function load(array $rows): void;
}
