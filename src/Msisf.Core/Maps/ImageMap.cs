namespace Msisf.Core.Maps;

/// <summary>Which pixel of an image each cell of a map shows. Cells have their borders at multiples of their width.</summary>
/// <param name="Cell">m: width of a cell.</param>
/// <param name="Left">m: X of the left edge.</param>
/// <param name="Top">m: Y of the upper edge.</param>
/// <param name="Pixels">
/// Line by line from the top: the pixel, counted by rows of the image from 0, in which the ground in the cell's middle is seen; -1 where
/// the image does not show it.
/// </param>
public sealed record ImageMap(
    ImageMapProjection Projection, double Cell, double Left, double Top, int Lines, int Samples, int ImagePixels, int[] Pixels);
