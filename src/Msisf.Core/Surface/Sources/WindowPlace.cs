namespace Msisf.Core.Surface.Sources;

/// <summary>Where a generated window lies: a rectangle of cells of a lattice.</summary>
/// <param name="Face">The map.</param>
/// <param name="Level">Cells are 2^Level m wide.</param>
/// <param name="Cells">The cells, counted in the lattice.</param>
internal readonly record struct WindowPlace(LatticeFace Face, int Level, CellRange Cells);
