using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>The three edges of a facet as a fill asks for them, row by row.</summary>
internal interface IFacetEdges
{
    /// <summary>Goes to a row, and tells between which columns, at least, pixels can lie in the facet.</summary>
    (double First, double Last) MoveTo(double row);

    /// <summary>Not above zero for the columns of the row that lie in the facet or on its border.</summary>
    Vector512<double> Outside(Vector512<double> columns);
}
