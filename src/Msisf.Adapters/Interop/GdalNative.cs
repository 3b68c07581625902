using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>
/// The functions of GDAL's C library that are used; C names, no logic. The library's name has a version in it and differs between
/// systems, so the functions are looked up when it is found.
/// </summary>
internal sealed unsafe class GdalNative
{
    /// <summary>GDAL_OF_RASTER of gdal.h.</summary>
    internal const uint OpenRaster = 2;

    /// <summary>GDT_Byte.</summary>
    internal const int TypeByte = 1;

    /// <summary>GDT_CInt16, the first of the types of complex numbers; GDT_CFloat64 is the last.</summary>
    internal const int FirstComplexType = 8;

    /// <summary>GDT_CFloat64.</summary>
    internal const int LastComplexType = 11;

    /// <summary>GDT_Float32.</summary>
    internal const int TypeFloat32 = 6;

    /// <summary>GDT_Int16.</summary>
    internal const int TypeInt16 = 3;

    /// <summary>GF_Read.</summary>
    internal const int ToRead = 0;

    /// <summary>OGRERR_NONE.</summary>
    internal const int NoError = 0;

    /// <summary>GDAL_DATA_COVERAGE_STATUS_DATA.</summary>
    internal const int CoverageData = 2;

    /// <summary>GDAL_DATA_COVERAGE_STATUS_EMPTY.</summary>
    internal const int CoverageEmpty = 4;

    /// <summary>OAMS_TRADITIONAL_GIS_ORDER: longitude before latitude.</summary>
    internal const int LongitudeFirst = 0;

    /// <summary>OAO_West.</summary>
    internal const int West = 4;

    /// <summary>CE_Warning.</summary>
    internal const int Warning = 2;

    /// <summary>CE_Failure; smaller results are successes or warnings.</summary>
    internal const int Failure = 3;

    internal readonly delegate* unmanaged[Cdecl]<void> GDALAllRegister;
    internal readonly delegate* unmanaged[Cdecl]<byte*, uint, nint, nint, nint, nint> GDALOpenEx;
    internal readonly delegate* unmanaged[Cdecl]<nint, void> GDALClose;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte**> GDALGetFileList;
    internal readonly delegate* unmanaged[Cdecl]<byte**, void> CSLDestroy;
    internal readonly delegate* unmanaged[Cdecl]<byte*, byte*, byte*> CPLGetConfigOption;
    internal readonly delegate* unmanaged[Cdecl]<byte*, byte*, void> CPLSetConfigOption;
    internal readonly delegate* unmanaged[Cdecl]<byte*, byte*, nint> VSIFOpenL;
    internal readonly delegate* unmanaged[Cdecl]<void*, nuint, nuint, nint, nuint> VSIFReadL;
    internal readonly delegate* unmanaged[Cdecl]<nint, ulong, int, int> VSIFSeekL;
    internal readonly delegate* unmanaged[Cdecl]<nint, ulong> VSIFTellL;
    internal readonly delegate* unmanaged[Cdecl]<nint, int> VSIFCloseL;
    internal readonly delegate* unmanaged[Cdecl]<byte*, int> VSIUnlink;
    internal readonly delegate* unmanaged[Cdecl]<nint, int> GDALGetRasterXSize;
    internal readonly delegate* unmanaged[Cdecl]<nint, int> GDALGetRasterYSize;
    internal readonly delegate* unmanaged[Cdecl]<nint, int, nint> GDALGetRasterBand;
    internal readonly delegate* unmanaged[Cdecl]<nint, int> GDALGetRasterDataType;
    internal readonly delegate* unmanaged[Cdecl]<nint, int*, int*, void> GDALGetBlockSize;
    internal readonly delegate* unmanaged[Cdecl]<nint, int*, double> GDALGetRasterNoDataValue;
    internal readonly delegate* unmanaged[Cdecl]<nint, double*, int> GDALGetGeoTransform;
    internal readonly delegate* unmanaged[Cdecl]<nint, int, int, int, int, int, void*, int, int, int, int, int, int> GDALRasterIO;
    internal readonly delegate* unmanaged[Cdecl]<nint, int, int*, long*, byte**, nint> GDALGetVirtualMemAuto;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte*> CPLVirtualMemGetAddr;
    internal readonly delegate* unmanaged[Cdecl]<nint, void> CPLVirtualMemFree;
    internal readonly delegate* unmanaged[Cdecl]<nint, int*, double> GDALGetRasterScale;
    internal readonly delegate* unmanaged[Cdecl]<nint, int*, double> GDALGetRasterOffset;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte*> GDALGetRasterUnitType;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte*, int> GDALSetRasterUnitType;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte*, void> GDALSetDescription;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte*> GDALGetProjectionRef;
    internal readonly delegate* unmanaged[Cdecl]<byte*, nint> OSRNewSpatialReference;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte**, int> OSRExportToProj4;
    internal readonly delegate* unmanaged[Cdecl]<nint, void> OSRDestroySpatialReference;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte*, int> OSRImportFromProj4;
    internal readonly delegate* unmanaged[Cdecl]<nint, int, void> OSRSetAxisMappingStrategy;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte*, int, int*, byte*> OSRGetAxis;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte**, double> OSRGetAngularUnits;
    internal readonly delegate* unmanaged[Cdecl]<nint, int> OSRIsGeographic;
    internal readonly delegate* unmanaged[Cdecl]<nint, nint, nint> OCTNewCoordinateTransformation;
    internal readonly delegate* unmanaged[Cdecl]<nint, int, double*, double*, double*, int*, int> OCTTransformEx;
    internal readonly delegate* unmanaged[Cdecl]<nint, void> OCTDestroyCoordinateTransformation;
    internal readonly delegate* unmanaged[Cdecl]<nint, int> GDALGetRasterCount;
    internal readonly delegate* unmanaged[Cdecl]<nint, int, int, int, int, int, double*, int> GDALGetDataCoverageStatus;
    internal readonly delegate* unmanaged[Cdecl]<nint, nint> GDALGetDatasetDriver;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte*> GDALGetDriverShortName;
    internal readonly delegate* unmanaged[Cdecl]<nint, byte*, byte**> GDALGetMetadata;
    internal readonly delegate* unmanaged[Cdecl]<byte**, nint, nint> GDALWarpAppOptionsNew;
    internal readonly delegate* unmanaged[Cdecl]<nint, void> GDALWarpAppOptionsFree;
    internal readonly delegate* unmanaged[Cdecl]<byte*, nint, int, nint*, nint, int*, nint> GDALWarp;
    internal readonly delegate* unmanaged[Cdecl]<byte**, nint, nint> GDALTranslateOptionsNew;
    internal readonly delegate* unmanaged[Cdecl]<nint, void> GDALTranslateOptionsFree;
    internal readonly delegate* unmanaged[Cdecl]<byte*, nint, nint, int*, nint> GDALTranslate;
    internal readonly delegate* unmanaged[Cdecl]<void*, void> VSIFree;
    internal readonly delegate* unmanaged[Cdecl]<void> CPLErrorReset;
    internal readonly delegate* unmanaged[Cdecl]<int> CPLGetLastErrorType;
    internal readonly delegate* unmanaged[Cdecl]<byte*> CPLGetLastErrorMsg;
    internal readonly delegate* unmanaged[Cdecl]<nint, nint> CPLSetErrorHandler;
    internal readonly nint CPLQuietErrorHandler;

    /// <summary>Looks the functions up.</summary>
    /// <param name="library">The loaded library.</param>
    /// <exception cref="EntryPointNotFoundException">It is not GDAL.</exception>
    internal GdalNative(nint library)
    {
        nint Find(string name) => NativeLibrary.GetExport(library, name);
        GDALAllRegister = (delegate* unmanaged[Cdecl]<void>)Find(nameof(GDALAllRegister));
        GDALOpenEx = (delegate* unmanaged[Cdecl]<byte*, uint, nint, nint, nint, nint>)Find(nameof(GDALOpenEx));
        GDALClose = (delegate* unmanaged[Cdecl]<nint, void>)Find(nameof(GDALClose));
        GDALGetFileList = (delegate* unmanaged[Cdecl]<nint, byte**>)Find(nameof(GDALGetFileList));
        CSLDestroy = (delegate* unmanaged[Cdecl]<byte**, void>)Find(nameof(CSLDestroy));
        CPLGetConfigOption = (delegate* unmanaged[Cdecl]<byte*, byte*, byte*>)Find(nameof(CPLGetConfigOption));
        CPLSetConfigOption = (delegate* unmanaged[Cdecl]<byte*, byte*, void>)Find(nameof(CPLSetConfigOption));
        VSIFOpenL = (delegate* unmanaged[Cdecl]<byte*, byte*, nint>)Find(nameof(VSIFOpenL));
        VSIFReadL = (delegate* unmanaged[Cdecl]<void*, nuint, nuint, nint, nuint>)Find(nameof(VSIFReadL));
        VSIFSeekL = (delegate* unmanaged[Cdecl]<nint, ulong, int, int>)Find(nameof(VSIFSeekL));
        VSIFTellL = (delegate* unmanaged[Cdecl]<nint, ulong>)Find(nameof(VSIFTellL));
        VSIFCloseL = (delegate* unmanaged[Cdecl]<nint, int>)Find(nameof(VSIFCloseL));
        VSIUnlink = (delegate* unmanaged[Cdecl]<byte*, int>)Find(nameof(VSIUnlink));
        GDALGetRasterXSize = (delegate* unmanaged[Cdecl]<nint, int>)Find(nameof(GDALGetRasterXSize));
        GDALGetRasterYSize = (delegate* unmanaged[Cdecl]<nint, int>)Find(nameof(GDALGetRasterYSize));
        GDALGetRasterBand = (delegate* unmanaged[Cdecl]<nint, int, nint>)Find(nameof(GDALGetRasterBand));
        GDALGetRasterDataType = (delegate* unmanaged[Cdecl]<nint, int>)Find(nameof(GDALGetRasterDataType));
        GDALGetBlockSize = (delegate* unmanaged[Cdecl]<nint, int*, int*, void>)Find(nameof(GDALGetBlockSize));
        GDALGetRasterNoDataValue = (delegate* unmanaged[Cdecl]<nint, int*, double>)Find(nameof(GDALGetRasterNoDataValue));
        GDALGetGeoTransform = (delegate* unmanaged[Cdecl]<nint, double*, int>)Find(nameof(GDALGetGeoTransform));
        GDALRasterIO = (delegate* unmanaged[Cdecl]<nint, int, int, int, int, int, void*, int, int, int, int, int, int>)
            Find(nameof(GDALRasterIO));
        GDALGetVirtualMemAuto =
            (delegate* unmanaged[Cdecl]<nint, int, int*, long*, byte**, nint>)Find(nameof(GDALGetVirtualMemAuto));
        CPLVirtualMemGetAddr = (delegate* unmanaged[Cdecl]<nint, byte*>)Find(nameof(CPLVirtualMemGetAddr));
        CPLVirtualMemFree = (delegate* unmanaged[Cdecl]<nint, void>)Find(nameof(CPLVirtualMemFree));
        GDALGetRasterScale = (delegate* unmanaged[Cdecl]<nint, int*, double>)Find(nameof(GDALGetRasterScale));
        GDALGetRasterOffset = (delegate* unmanaged[Cdecl]<nint, int*, double>)Find(nameof(GDALGetRasterOffset));
        GDALGetRasterUnitType = (delegate* unmanaged[Cdecl]<nint, byte*>)Find(nameof(GDALGetRasterUnitType));
        GDALSetRasterUnitType = (delegate* unmanaged[Cdecl]<nint, byte*, int>)Find(nameof(GDALSetRasterUnitType));
        GDALSetDescription = (delegate* unmanaged[Cdecl]<nint, byte*, void>)Find(nameof(GDALSetDescription));
        GDALGetProjectionRef = (delegate* unmanaged[Cdecl]<nint, byte*>)Find(nameof(GDALGetProjectionRef));
        OSRNewSpatialReference = (delegate* unmanaged[Cdecl]<byte*, nint>)Find(nameof(OSRNewSpatialReference));
        OSRExportToProj4 = (delegate* unmanaged[Cdecl]<nint, byte**, int>)Find(nameof(OSRExportToProj4));
        OSRDestroySpatialReference = (delegate* unmanaged[Cdecl]<nint, void>)Find(nameof(OSRDestroySpatialReference));
        OSRImportFromProj4 = (delegate* unmanaged[Cdecl]<nint, byte*, int>)Find(nameof(OSRImportFromProj4));
        OSRSetAxisMappingStrategy = (delegate* unmanaged[Cdecl]<nint, int, void>)Find(nameof(OSRSetAxisMappingStrategy));
        OSRGetAxis = (delegate* unmanaged[Cdecl]<nint, byte*, int, int*, byte*>)Find(nameof(OSRGetAxis));
        OSRGetAngularUnits = (delegate* unmanaged[Cdecl]<nint, byte**, double>)Find(nameof(OSRGetAngularUnits));
        OSRIsGeographic = (delegate* unmanaged[Cdecl]<nint, int>)Find(nameof(OSRIsGeographic));
        OCTNewCoordinateTransformation = (delegate* unmanaged[Cdecl]<nint, nint, nint>)Find(nameof(OCTNewCoordinateTransformation));
        OCTTransformEx = (delegate* unmanaged[Cdecl]<nint, int, double*, double*, double*, int*, int>)Find(nameof(OCTTransformEx));
        OCTDestroyCoordinateTransformation =
            (delegate* unmanaged[Cdecl]<nint, void>)Find(nameof(OCTDestroyCoordinateTransformation));
        GDALGetRasterCount = (delegate* unmanaged[Cdecl]<nint, int>)Find(nameof(GDALGetRasterCount));
        GDALGetDataCoverageStatus =
            (delegate* unmanaged[Cdecl]<nint, int, int, int, int, int, double*, int>)Find(nameof(GDALGetDataCoverageStatus));
        GDALGetDatasetDriver = (delegate* unmanaged[Cdecl]<nint, nint>)Find(nameof(GDALGetDatasetDriver));
        GDALGetDriverShortName = (delegate* unmanaged[Cdecl]<nint, byte*>)Find(nameof(GDALGetDriverShortName));
        GDALGetMetadata = (delegate* unmanaged[Cdecl]<nint, byte*, byte**>)Find(nameof(GDALGetMetadata));
        GDALWarpAppOptionsNew = (delegate* unmanaged[Cdecl]<byte**, nint, nint>)Find(nameof(GDALWarpAppOptionsNew));
        GDALWarpAppOptionsFree = (delegate* unmanaged[Cdecl]<nint, void>)Find(nameof(GDALWarpAppOptionsFree));
        GDALWarp = (delegate* unmanaged[Cdecl]<byte*, nint, int, nint*, nint, int*, nint>)Find(nameof(GDALWarp));
        GDALTranslateOptionsNew = (delegate* unmanaged[Cdecl]<byte**, nint, nint>)Find(nameof(GDALTranslateOptionsNew));
        GDALTranslateOptionsFree = (delegate* unmanaged[Cdecl]<nint, void>)Find(nameof(GDALTranslateOptionsFree));
        GDALTranslate = (delegate* unmanaged[Cdecl]<byte*, nint, nint, int*, nint>)Find(nameof(GDALTranslate));
        VSIFree = (delegate* unmanaged[Cdecl]<void*, void>)Find(nameof(VSIFree));
        CPLErrorReset = (delegate* unmanaged[Cdecl]<void>)Find(nameof(CPLErrorReset));
        CPLGetLastErrorType = (delegate* unmanaged[Cdecl]<int>)Find(nameof(CPLGetLastErrorType));
        CPLGetLastErrorMsg = (delegate* unmanaged[Cdecl]<byte*>)Find(nameof(CPLGetLastErrorMsg));
        CPLSetErrorHandler = (delegate* unmanaged[Cdecl]<nint, nint>)Find(nameof(CPLSetErrorHandler));
        CPLQuietErrorHandler = Find(nameof(CPLQuietErrorHandler));
    }
}
