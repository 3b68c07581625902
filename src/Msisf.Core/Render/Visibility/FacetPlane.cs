namespace Msisf.Core.Render.Visibility;

/// <summary>One over the ray parameter at which a pixel's ray meets a facet's plane, linear in column and row.</summary>
/// <param name="Constant">Its value at column 0, row 0.</param>
/// <param name="PerColumn">What a column adds.</param>
/// <param name="PerRow">What a row adds.</param>
/// <param name="Least">Its least value on the facet.</param>
/// <param name="Greatest">Its greatest value on the facet.</param>
internal readonly record struct FacetPlane(double Constant, double PerColumn, double PerRow, double Least, double Greatest);
